package org.hificamsim.agents.cooperative;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.hificamsim.core.policy.NetworkView;

/**
 * A camera's belief and plan, and the last choice that it received from each other camera. Over a
 * perfect channel all cameras share one mind.
 */
final class Mind {
  private static final long NEVER = -1;

  private static final Comparator<SightingReport> IN_ORDER_SENT =
      Comparator.comparingLong(SightingReport::step).thenComparingInt(SightingReport::camera);

  private final Belief belief;
  private final Plan plan;
  private final List<SightingReport> inbox = new ArrayList<>();
  private final int[][] lastWays;
  private final int[] continuedWay;
  private final long[] lastChoiceSteps;

  Mind(Parameters parameters, Worth worth, Site site, NetworkView network) {
    belief = new Belief(parameters, worth, site, network);
    plan = new Plan(parameters, worth, network.cameras());
    lastWays = new int[network.cameras()][parameters.horizon()];
    continuedWay = new int[parameters.horizon()];
    lastChoiceSteps = new long[network.cameras()];
    Arrays.fill(lastChoiceSteps, NEVER);
  }

  /** Receives a report. */
  void receive(SightingReport report) {
    inbox.add(report);
  }

  /**
   * Takes the way that a camera chose, its own or a received one, into the plan. A way that was
   * chosen in an earlier step is kept for the next plan.
   *
   * @param sentAt the step in which the camera chose
   * @param now the present step
   */
  void learnChoice(int camera, int[] way, long sentAt, long now) {
    if (sentAt >= lastChoiceSteps[camera]) {
      System.arraycopy(way, 0, lastWays[camera], 0, way.length);
      lastChoiceSteps[camera] = sentAt;
    }
    if (sentAt == now) {
      plan.choose(camera, way);
    }
  }

  /** Whether a camera is known to have chosen this way in a step. */
  boolean knowsChoice(int camera, int[] way, long step) {
    return lastChoiceSteps[camera] == step && Arrays.equals(lastWays[camera], way);
  }

  /** Sorts the reports that have arrived by the step in which they were sent, then by camera. */
  void sortReports() {
    inbox.sort(IN_ORDER_SENT);
  }

  /** Updates the belief with the reports that have arrived. */
  void believe(NetworkView network) {
    belief.begin();
    for (int i = 0; i < inbox.size(); i++) {
      belief.receive(network, inbox.get(i));
    }
    belief.end(network);
    inbox.clear();
  }

  /** Begins a plan in which every camera goes on with its last known way. */
  void beginPlan(NetworkView network) {
    plan.begin(network, belief);
    for (int camera = 0; camera < lastWays.length; camera++) {
      if (network.online(camera) && lastChoiceSteps[camera] != NEVER) {
        long age = network.step() - lastChoiceSteps[camera];
        Ways.after(lastWays[camera], age, network.views(camera), continuedWay);
        plan.choose(camera, continuedWay);
      }
    }
  }

  /** Plans the best view for a camera; returns whether it differs from the one planned before. */
  boolean replan(NetworkView network, int camera) {
    int before = plan.view(camera);
    int view = plan.best(network, camera);
    learnChoice(camera, plan.wayTo(network, camera, view), network.step(), network.step());
    return view != before;
  }

  Belief belief() {
    return belief;
  }

  Plan plan() {
    return plan;
  }
}
