package org.hificamsim.runs.output;

import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;

/** How much a run's folder says of each step. */
public enum Detail {
  /** What all cameras cover between them. */
  STEPS,
  /** Each camera's zoom level and each target's place as well. */
  ZOOMS,
  /** The same, and where cameras with optics look. */
  VIEWS;

  /** What is recorded of a scenario in full. */
  public static Detail full(Scenario scenario) {
    boolean turns = scenario.everyCamera().map(CameraSpec::optics).anyMatch(o -> o.isPresent());
    return turns ? VIEWS : ZOOMS;
  }
}
