package org.hificamsim.presentation.view;

import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;

/** Measures the zones of a scenario that is edited, but only if it has changed since. */
final class MeasuredZones {
  private final Planner planner;

  /** The scenario whose zones were measured; null if the shares are out of date. */
  private Scenario measured;

  private List<ShownZone> zones = List.of();

  MeasuredZones(Planner planner) {
    this.planner = planner;
  }

  /** Forgets the shares, because another detection sees the zones now. */
  void forget() {
    measured = null;
  }

  /**
   * Returns the zones, with the share of each that the cameras can see from where they are.
   *
   * @param usual the detection of zones that name none
   */
  List<ShownZone> of(Scenario scenario, Detection usual) {
    if (!scenario.equals(measured)) {
      measured = scenario;
      zones = ShownZone.of(scenario, usual, shares(usual));
    }
    return zones;
  }

  private List<Planner.Share> shares(Detection usual) {
    try {
      return planner.shares(measured, usual);
    } catch (InputException e) {
      return List.of(); // detection is by chance
    }
  }
}
