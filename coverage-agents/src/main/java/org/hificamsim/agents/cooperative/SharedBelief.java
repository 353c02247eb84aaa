package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * The belief of {@code cooperative} cameras for policies that decide in another way: what each
 * camera believes that its views would add. The cameras send each other what they see, and which
 * views they chose, over the channel of the network.
 *
 * <p>In each step, call {@link #update} before the decision and {@link #learnChoices} after it.
 */
public final class SharedBelief {
  /**
   * The parameters, which stay as they are when the policy's defaults change, since trained
   * networks depend on them.
   */
  private static final String PARAMETERS = "search=0.4,further=0.2,hold=0";

  private final BeliefExchange exchange;
  private final ViewOutlook[] outlooks;

  /** Creates the belief of a network at the start of a run. */
  public SharedBelief(NetworkView network) {
    Parameters parameters = Parameters.from(Options.parse("belief", PARAMETERS));
    exchange = new BeliefExchange(parameters, network, network.obstacles(), false);
    outlooks = new ViewOutlook[network.cameras()];
    Arrays.setAll(outlooks, camera -> new ViewOutlook());
  }

  /** Lets all cameras report what they see, and computes what their views promise. */
  public void update(NetworkView network) {
    exchange.share(network);
    Team team = exchange.team();
    for (int camera = 0; camera < outlooks.length; camera++) {
      if (network.online(camera)) {
        outlooks[camera].read(network, camera, team.plan(camera));
      } else {
        outlooks[camera].begin(0);
      }
    }
  }

  /**
   * Lets all cameras send which views they chose.
   *
   * @param views chosen by each camera in this step
   */
  public void learnChoices(NetworkView network, int[] views) {
    for (int camera = 0; camera < views.length; camera++) {
      if (network.online(camera)) {
        exchange.team().choose(network, camera, views[camera]);
      }
    }
  }

  /** The promises of the views of a camera, as of the last update. */
  public ViewOutlook outlook(int camera) {
    return outlooks[camera];
  }

  /** The number of messages sent since the beginning of the run. */
  public long messages() {
    return exchange.team().messages();
  }

  /** The length of all these messages, in bits. */
  public long bits() {
    return exchange.team().bits();
  }
}
