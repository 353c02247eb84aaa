package org.hificamsim.core.world;

import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.DutyCycle;

/** Lets cameras with a duty cycle sleep and wake up. */
final class Shifts {
  private final Cameras cameras;

  /** The duty cycle of each camera; null for a camera that is always awake. */
  private final DutyCycle[] cycles;

  private final boolean[] sleeps;
  private boolean any;

  Shifts(Cameras cameras) {
    this.cameras = cameras;
    cycles = new DutyCycle[cameras.count()];
    sleeps = new boolean[cameras.count()];
  }

  void define(int camera, CameraSpec spec) {
    cycles[camera] = spec.find(CameraSpec.DUTY).orElse(null);
    sleeps[camera] = false;
    any |= cycles[camera] != null;
  }

  /** Switches cameras for a step; those that are off for another reason stay off. */
  void begin(long step) {
    for (int camera = 0; any && camera < cycles.length; camera++) {
      boolean follows = cycles[camera] != null && (cameras.online(camera) || sleeps[camera]);
      if (follows && cycles[camera].isAwake(step) == sleeps[camera]) {
        sleeps[camera] = !sleeps[camera];
        cameras.switchTo(camera, !sleeps[camera]);
      }
    }
  }

  boolean sleeps(int camera) {
    return sleeps[camera];
  }

  /** Marks a camera as not sleeping, since it is switched off for another reason. */
  void end(int camera) {
    sleeps[camera] = false;
  }
}
