package org.hificamsim.agents.cooperative;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.hificamsim.core.policy.NetworkView;

/**
 * What a camera believes and plans, and the last choice of each other camera that it received. Over
 * a perfect channel all cameras share one mind.
 */
final class Mind {
  private static final Comparator<SightingReport> IN_ORDER_SENT =
      Comparator.comparingLong(SightingReport::step).thenComparingInt(SightingReport::camera);

  private final Belief belief;
  private final Plan plan;
  private final List<SightingReport> inbox = new ArrayList<>();
  private final int[] lastChoices;
  private final long[] lastChoiceSteps;

  Mind(Parameters parameters, Worth worth, Site site, NetworkView network) {
    belief = new Belief(parameters, worth, site, network);
    plan = new Plan(parameters, worth, network.cameras());
    lastChoices = new int[network.cameras()];
    lastChoiceSteps = new long[network.cameras()];
    Arrays.fill(lastChoices, Plan.NONE);
  }

  /** Receives a report. */
  void receive(SightingReport report) {
    inbox.add(report);
  }

  /**
   * Takes the choice of a camera, its own or a received one, into the plan. A choice of an earlier
   * step is kept for the next plan.
   *
   * @param sentAt the step in which the camera chose
   * @param now the present step
   */
  void learnChoice(int camera, int view, long sentAt, long now) {
    if (sentAt >= lastChoiceSteps[camera]) {
      lastChoices[camera] = view;
      lastChoiceSteps[camera] = sentAt;
    }
    if (sentAt == now) {
      plan.choose(camera, view);
    }
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

  /** Begins a plan in which every camera keeps to its last known choice. */
  void beginPlan(NetworkView network) {
    plan.begin(network, belief);
    for (int camera = 0; camera < lastChoices.length; camera++) {
      if (network.online(camera) && lastChoices[camera] != Plan.NONE) {
        plan.choose(camera, Math.min(lastChoices[camera], network.views(camera) - 1));
      }
    }
  }

  /** Plans the best view for a camera; returns whether it differs from the one planned before. */
  boolean replan(NetworkView network, int camera) {
    int before = plan.view(camera);
    int view = plan.best(network, camera);
    learnChoice(camera, view, network.step(), network.step());
    return view != before;
  }

  Belief belief() {
    return belief;
  }

  Plan plan() {
    return plan;
  }
}
