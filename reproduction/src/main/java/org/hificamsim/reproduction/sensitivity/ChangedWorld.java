package org.hificamsim.reproduction.sensitivity;

import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.hifi.optics.Optics;

/** A scenario with other targets or other optics, under a name that tells what is changed. */
final class ChangedWorld {
  private ChangedWorld() {}

  /** All targets of another size q, metres. */
  static Scenario withSize(Scenario scenario, double size) {
    return scenario
        .withTargets(target -> target.withSize(size))
        .with(Scenario.NAME, scenario.name() + "-q" + size);
  }

  /**
   * All cameras at the height at which the narrowest level has a focal length (Eqs 3.1, 3.2).
   *
   * @param focalLength metres, above 0
   */
  static Scenario withFocalLength(Scenario scenario, Optics optics, double focalLength) {
    double height = 2 * focalLength * scenario.zooms().get(0) / optics.sensorWidth();
    return scenario
        .with(Scenario.NAME, scenario.name() + "-z" + focalLength)
        .with(Scenario.MOUNT_HEIGHT, height);
  }
}
