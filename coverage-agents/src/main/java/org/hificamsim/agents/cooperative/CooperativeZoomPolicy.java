package org.hificamsim.agents.cooperative;

import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.policy.BeliefListener;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.TrackingZoomPolicy;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.scenario.ScenarioReader;

/**
 * A policy of cameras that report to each other what they see, estimate where targets are and where
 * they go, and divide the targets among themselves. A camera knows what it sees and receives, where
 * all cameras stand, how long moves take, and the map of the site. It does not know where the
 * targets are that no camera sees, nor how many targets there are.
 *
 * <p>In each step, cameras send reports ({@link SightingReport}), update what they believe ({@link
 * Belief}), look ahead ({@link Plan}), and agree on their views ({@link Agreement}). All of this is
 * done in {@link #decide}: a {@link Team} passes the messages between the {@link Mind}s, which have
 * a belief and a plan each.
 */
public final class CooperativeZoomPolicy implements TrackingZoomPolicy {
  private static final String SITE_MAP = "site";
  private static final String NO_MAP = "none";

  private final Parameters parameters;
  private final Agreement.Rule rule;
  private final boolean individual;
  private final String map;
  private final Obstacles mapFromFile;
  private Agreement agreement;
  private NetworkView network;
  private BeliefExchange exchange;
  private Team team;

  /** Reads the options of the policy. */
  public CooperativeZoomPolicy(Options options) {
    this(options, false);
  }

  /**
   * @param individual whether each camera has its own mind even over a perfect channel
   */
  CooperativeZoomPolicy(Options options, boolean individual) {
    this.individual = individual;
    rule =
        options.choice(
            "agree",
            Agreement.Rule.GREEDY,
            "who chooses what: greedy (in turn), cbba, log-linear, max-sum, none (no messages)");
    parameters = Parameters.from(options);
    map =
        options.text("map", SITE_MAP, "site, none, or a scenario file whose obstacles are the map");
    mapFromFile = isFile(map) ? obstacles(Path.of(map)) : Obstacles.NONE;
  }

  private static boolean isFile(String map) {
    return !map.equals(SITE_MAP) && !map.equals(NO_MAP);
  }

  @Override
  public String name() {
    return "cooperative";
  }

  private static Obstacles obstacles(Path scenario) {
    return new Obstacles(
        ScenarioReader.read(scenario, movement -> true, warning -> {}).obstacles());
  }

  /** The scenario file with the map, if one is given. */
  @Override
  public List<Path> files() {
    return isFile(map) ? List.of(Path.of(map)) : List.of();
  }

  @Override
  public void begin(NetworkView newNetwork, SplittableRandom random) {
    network = newNetwork;
    agreement = rule.make(parameters, network, random);
    Obstacles obstacles = map.equals(SITE_MAP) ? network.obstacles() : mapFromFile;
    exchange = new BeliefExchange(parameters, network, obstacles, individual);
    team = exchange.team();
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    exchange.share(network);
    agreement.agree(network, team);
    for (int camera = 0; camera < views.length; camera++) {
      views[camera] = network.online(camera) ? team.chosenView(camera) : views[camera];
    }
  }

  /** The worth that each view would have added to the views of all other cameras. */
  @Override
  public String estimates(int camera, double[] estimates, double[] counts) {
    Arrays.fill(counts, Double.NaN);
    Arrays.fill(estimates, Double.NaN);
    Plan plan = team.plan(camera);
    if (plan.view(camera) != Plan.NONE) {
      System.arraycopy(plan.gains(network, camera), 0, estimates, 0, network.views(camera));
    }
    return "gain";
  }

  @Override
  public boolean believe(int camera, BeliefListener listener) {
    team.mind(camera).belief().report(network.step(), listener);
    team.reportMessages(network, listener);
    return true;
  }

  @Override
  public double identitySwitches() {
    return team == null || parameters.identified() ? Double.NaN : team.identitySwitches();
  }

  @Override
  public long messages() {
    return team == null ? 0 : team.messages();
  }

  @Override
  public long bits() {
    return team == null ? 0 : team.bits();
  }
}
