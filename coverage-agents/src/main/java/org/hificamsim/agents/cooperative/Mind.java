package org.hificamsim.agents.cooperative;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.hificamsim.core.policy.NetworkView;

/**
 * What a camera believes and plans, and what it last received of the others' choices. Over a
 * perfect channel one mind serves all cameras.
 */
final class Mind {
  private static final Comparator<SightingReport> ORDER =
      Comparator.comparingLong(SightingReport::step).thenComparingInt(SightingReport::camera);

  private final Belief belief;
  private final Plan plan;
  private final List<SightingReport> inbox = new ArrayList<>();
  private final int[] heard; // the last choice of each camera that was received
  private final long[] heardAt; // the step in which it was made

  Mind(Parameters parameters, Worth worth, Site site, NetworkView network) {
    belief = new Belief(parameters, worth, site, network);
    plan = new Plan(parameters, worth, network.cameras());
    heard = new int[network.cameras()];
    heardAt = new long[heard.length];
    Arrays.fill(heard, Plan.NONE);
  }

  /** A report has arrived. */
  void receive(SightingReport report) {
    inbox.add(report);
  }

  /**
   * A camera's choice is known: its own, or another one's that has arrived. One of an earlier step
   * is what the next plan begins with.
   */
  void hear(int camera, int view, long sent, long now) {
    if (sent >= heardAt[camera]) {
      heard[camera] = view;
      heardAt[camera] = sent;
    }
    if (sent == now) {
      plan.choose(camera, view);
    }
  }

  /** Puts what has arrived over a channel in the order in which it was sent. */
  void sort() {
    inbox.sort(ORDER);
  }

  /** Comes to a belief from what has arrived. */
  void believe(NetworkView network) {
    belief.begin();
    for (int i = 0; i < inbox.size(); i++) {
      belief.receive(network, inbox.get(i));
    }
    belief.end(network);
    inbox.clear();
  }

  /** Begins a plan in which all go on to what they last chose, as far as is known. */
  void plan(NetworkView network) {
    plan.begin(network, belief);
    for (int camera = 0; camera < heard.length; camera++) {
      if (network.online(camera) && heard[camera] != Plan.NONE) {
        plan.choose(camera, Math.min(heard[camera], network.views(camera) - 1));
      }
    }
  }

  /** Plans the best view for a camera; returns whether it is another one than before. */
  boolean choose(NetworkView network, int camera) {
    int before = plan.view(camera);
    int view = plan.best(network, camera);
    hear(camera, view, network.step(), network.step());
    return view != before;
  }

  Belief belief() {
    return belief;
  }

  Plan plan() {
    return plan;
  }
}
