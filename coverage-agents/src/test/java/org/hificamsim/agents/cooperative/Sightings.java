package org.hificamsim.agents.cooperative;

import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.policy.SeenPairs;

/** Reports of one sighting each, for tests. */
final class Sightings {
  private Sightings() {}

  /** The report of a camera that sees a target at a position, in metres, in a step. */
  static SightingReport at(long step, int target, double x, double y) {
    ToyNetwork network = new ToyNetwork(target + 1, 1);
    while (network.step() < step) {
      network.nextStep();
    }
    SeenPairs pairs = new SeenPairs();
    pairs.add(0, target, y, x); // ahead of and to the right of a camera at the origin
    SightingReport report = new SightingReport(true);
    report.begin(network, 0);
    report.add(network, pairs, 0);
    return report;
  }
}
