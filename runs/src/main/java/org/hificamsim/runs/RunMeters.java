package org.hificamsim.runs;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.engine.FollowingSums;
import org.hificamsim.core.engine.RunCoverage;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.engine.TargetFollowing;
import org.hificamsim.core.policy.TrackingZoomPolicy;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Following;
import org.hificamsim.runs.cells.ZoneRecorder;

/**
 * The listeners that measure a repeat.
 *
 * @param zones the recorder of zones; null without zones
 * @param following the recorder of following; null unless the scenario asks for it
 */
record RunMeters(RunCoverage coverage, ZoneRecorder zones, TargetFollowing following) {
  /** Creates the meters of a repeat of a plan. */
  static RunMeters of(RunPlan plan, Catalogue catalogue) {
    Scenario scenario = plan.scenario();
    return new RunMeters(
        new RunCoverage(),
        scenario.zones().isEmpty() ? null : zones(plan, catalogue),
        scenario.following() == Following.TARGETS ? new TargetFollowing() : null);
  }

  private static ZoneRecorder zones(RunPlan plan, Catalogue catalogue) {
    return new ZoneRecorder(
        plan.scenario(),
        plan.detection(),
        name -> DetectionSpec.parse(name, catalogue::detection).detection(Settings.NONE));
  }

  /** All meters with the other listeners of the repeat, in the order in which they are called. */
  List<StepListener> with(List<StepListener> listeners) {
    List<StepListener> all = new ArrayList<>();
    all.add(coverage);
    all.addAll(listeners);
    if (zones != null) {
      all.add(zones);
    }
    if (following != null) {
      all.add(following);
    }
    return all;
  }

  Measured.Zones zoneShares() {
    return zones == null
        ? Measured.Zones.NONE
        : new Measured.Zones(zones.met(), zones.least(), zones.shares());
  }

  FollowingSums followingSums() {
    return following == null ? FollowingSums.NONE : following.sums();
  }

  /** The identity switches of a policy that keeps its own tracks; NaN for all other policies. */
  double identitySwitches(ZoomPolicy policy) {
    return following != null && policy instanceof TrackingZoomPolicy tracking
        ? tracking.identitySwitches()
        : Double.NaN;
  }
}
