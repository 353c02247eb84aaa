package org.hificamsim.runs.output;

import org.hificamsim.core.scenario.Scenario;

/** The detail in which each step is written to the folder of a run. */
public enum Detail {
  /** The coverage of all cameras together. */
  STEPS,
  /** The measures, and the zoom level of each camera and the position of each target. */
  ZOOMS,
  /** In addition, the direction and angle of view of cameras with optics. */
  VIEWS;

  /** The most detailed recording of a scenario. */
  public static Detail full(Scenario scenario) {
    boolean hasOptics = scenario.everyCamera().anyMatch(camera -> camera.optics().isPresent());
    return hasOptics ? VIEWS : ZOOMS;
  }
}
