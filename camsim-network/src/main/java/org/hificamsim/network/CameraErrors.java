package org.hificamsim.network;

import java.util.Random;
import org.hificamsim.core.world.World;
import org.hificamsim.network.agent.Agent;

/**
 * Makes cameras fail at random, and ends these failures (behaviour 7, step 4; quirks Q6, Q15, Q18).
 *
 * <p>A duration of 0 brings a camera back that has failed for a limited time, but not one that an
 * event has switched off for ever.
 */
final class CameraErrors {
  private static final int FOR_EVER = -1;
  private static final int PERCENT = 100;
  private static final int DURATIONS = 10;

  private final World world;
  private final Random random;
  private final int errorLevel;
  private final int resetLevel;
  private final boolean failuresEnd;
  private final boolean[] offForEver;
  private final int[] stepsLeft;

  CameraErrors(World world, NetworkSettings settings, Random random) {
    this.world = world;
    this.random = random;
    errorLevel = settings.errorLevel();
    resetLevel = settings.resetLevel();
    failuresEnd = !settings.has(Quirk.FAILED_CAMERAS_STAY_OFFLINE);
    offForEver = new boolean[world.cameras().count()];
    stepsLeft = new int[world.cameras().count()];
  }

  /** Records that an event has switched a camera off. */
  void switchedOff(int camera, int duration) {
    offForEver[camera] |= duration == FOR_EVER;
    stepsLeft[camera] = duration;
  }

  /**
   * Draws which camera fails in this step. CamSim always draws a number; here nothing is drawn
   * below level 0, where the draw has no effect.
   *
   * @return whether a camera has forgotten its neighbours
   */
  boolean step(Agent[] agents, int cameras) {
    if (failuresEnd) {
      countDown(cameras);
    }
    if (errorLevel < 0 || random.nextInt(PERCENT) > errorLevel || cameras == 0) {
      return false;
    }
    int camera = random.nextInt(cameras);
    int duration = random.nextInt(DURATIONS);
    if (!offForEver[camera]) {
      // countDown has already run in this step.
      stepsLeft[camera] = duration - 1;
      world.switchCamera(camera, duration == 0);
    }
    boolean forgets = random.nextInt(PERCENT) > resetLevel;
    if (forgets) {
      agents[camera].forgetNeighbours();
    }
    return forgets;
  }

  private void countDown(int cameras) {
    for (int camera = 0; camera < cameras; camera++) {
      if (!world.cameras().online(camera) && !offForEver[camera] && stepsLeft[camera]-- <= 0) {
        world.switchCamera(camera, true);
      }
    }
  }
}
