package org.hificamsim.network.files;

import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Cooperation;
import org.hificamsim.core.engine.NetworkModel;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.world.World;
import org.hificamsim.network.Network;
import org.hificamsim.network.NetworkSettings;
import org.hificamsim.network.Strategy;
import org.hificamsim.network.agent.Named;
import org.hificamsim.network.bandit.BanditAlgorithm;

/**
 * CamSim's network as selected by the text of a plan: {@code
 * camsim:strategies=A0-P2,bandit=UCB1,alpha=0.5}.
 */
public final class NetworkText implements NetworkModel {
  private NetworkSettings settings = NetworkSettings.CAMSIM;

  @Override
  public String name() {
    return "camsim";
  }

  /** Returns the text that selects strategies, one for all cameras or one for each. */
  public static String of(List<Strategy> strategies) {
    return "camsim:strategies=" + Strategy.text(strategies);
  }

  /** Returns the text that selects a bandit for all cameras, with its weight of utility. */
  public static String of(BanditAlgorithm bandit, double alpha) {
    return "camsim:bandit=" + bandit.names().get(0) + ",alpha=" + alpha;
  }

  @Override
  public void configure(Options options) {
    String strategies = options.text("strategies", "", "of all cameras, or of each");
    String bandit = options.text("bandit", "", "of all cameras");
    double alpha = options.number("alpha", 0.5, 0, 1, "a bandit's weight of utility");
    if (!strategies.isEmpty()) {
      settings = settings.withStrategies(Strategy.parse(strategies));
    }
    if (!bandit.isEmpty()) {
      settings = settings.withBandit(bandit(bandit), alpha);
    }
  }

  /**
   * Returns the bandit with a name.
   *
   * @throws InputException if there is no such bandit
   */
  public static BanditAlgorithm bandit(String name) {
    return Named.find(BanditAlgorithm.class, name)
        .orElseThrow(
            () ->
                InputException.of(
                    "bandit is '%s', expected %s", name, Named.expected(BanditAlgorithm.class)));
  }

  @Override
  public Cooperation begin(World world, Detection detection, long seed) {
    return new Network(world, detection, settings, seed);
  }
}
