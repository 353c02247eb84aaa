package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.core.policy.BeliefListener;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;

/**
 * Cameras that tell each other what they see, believe the same of where targets are and go, and
 * divide them among them. It knows what cameras see, where they stand, how long their moves take,
 * and the site's map; not where targets are that nobody sees, nor how many there are.
 *
 * <p>In each step: share ({@link Report}), believe ({@link Belief}), look ahead ({@link Plan}),
 * agree ({@link SequentialGreedy}).
 */
public final class CooperativeZoomPolicy implements ZoomPolicy {
  private final Parameters parameters;
  private final SequentialGreedy agreement;
  private final SeenPairs pairs = new SeenPairs();
  private Report[] reports = {};
  private Belief belief;
  private Plan plan;

  /** Reads the options. */
  public CooperativeZoomPolicy(Options options) {
    parameters = Parameters.from(options);
    agreement = new SequentialGreedy(parameters);
  }

  @Override
  public String name() {
    return "cooperative";
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    reports = new Report[network.cameras()];
    Arrays.setAll(reports, camera -> new Report());
    Worth worth = new Worth(network.objective(), parameters.lead());
    belief = new Belief(parameters, network);
    plan = new Plan(parameters, worth, reports.length);
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    look(network);
    belief.begin(network);
    for (Report report : reports) {
      belief.receive(network, report, network.step());
    }
    belief.end(network);
    plan.begin(network, belief);
    agreement.agree(network, plan);
    for (int camera = 0; camera < views.length; camera++) {
      views[camera] = network.online(camera) ? plan.view(camera) : views[camera];
    }
  }

  /** What each view would have added to those that all others chose. */
  @Override
  public String estimates(NetworkView network, int camera, double[] estimates, double[] counts) {
    Arrays.fill(counts, Double.NaN);
    Arrays.fill(estimates, Double.NaN);
    int chosen = plan.view(camera);
    if (chosen != Plan.NONE) {
      plan.change(camera, Plan.NONE);
      System.arraycopy(plan.gains(network, camera), 0, estimates, 0, network.views(camera));
      plan.change(camera, chosen);
    }
    return "gain";
  }

  @Override
  public boolean believe(NetworkView network, int camera, BeliefListener listener) {
    belief.tell(network.step(), listener);
    return true;
  }

  private void look(NetworkView network) {
    for (int camera = 0; camera < reports.length; camera++) {
      reports[camera].begin(network, camera);
    }
    network.findSeen(pairs);
    for (int pair = 0; pair < pairs.count(); pair++) {
      reports[pairs.camera(pair)].add(network, pairs, pair);
    }
  }
}
