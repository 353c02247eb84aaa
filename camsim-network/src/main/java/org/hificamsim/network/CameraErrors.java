package org.hificamsim.network;

import java.util.Random;
import org.hificamsim.core.world.World;
import org.hificamsim.network.agent.Agent;

/**
 * Cameras that fail by chance, and those that come back (behaviour 7, step 4; quirks Q6, Q15, Q18).
 *
 * <p>A duration of 0 brings a camera back that failed for some steps before, but not one that an
 * event switched off for ever.
 */
final class CameraErrors {
  private static final int FOR_EVER = -1;
  private static final int PERCENT = 100;
  private static final int DURATIONS = 10;

  private final World world;
  private final Random random;
  private final int errorLevel;
  private final int resetLevel;
  private final boolean comeBack;
  private final boolean[] forEver;
  private final int[] stepsLeft;

  CameraErrors(World world, NetworkSettings settings, Random random) {
    this.world = world;
    this.random = random;
    errorLevel = settings.errorLevel();
    resetLevel = settings.resetLevel();
    comeBack = !settings.has(Quirk.FAILED_CAMERAS_STAY_OFFLINE);
    forEver = new boolean[world.cameras().count()];
    stepsLeft = new int[world.cameras().count()];
  }

  /** Notes that an event switched a camera off. */
  void failed(int camera, int duration) {
    forEver[camera] |= duration == FOR_EVER;
    stepsLeft[camera] = duration;
  }

  /**
   * Draws who fails in this step. CamSim draws a number in any case; below level 0, where the draws
   * decide about nothing, none is drawn here.
   *
   * @return whether a camera has forgotten its neighbours
   */
  boolean step(Agent[] agents, int cameras) {
    if (comeBack) {
      countDown(cameras);
    }
    if (errorLevel < 0 || random.nextInt(PERCENT) > errorLevel || cameras == 0) {
      return false;
    }
    int camera = random.nextInt(cameras);
    int duration = random.nextInt(DURATIONS);
    if (!forEver[camera]) {
      stepsLeft[camera] = duration - 1; // this step's count is over
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
      if (!world.cameras().online(camera) && !forEver[camera] && stepsLeft[camera]-- <= 0) {
        world.switchCamera(camera, true);
      }
    }
  }
}
