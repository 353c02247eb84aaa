package org.hificamsim.bridge.run;

import java.util.SplittableRandom;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * A zoom policy that sets the ranges of CamSim's cameras.
 *
 * <p>Policies size their tables when they begin, and CamSim does not say what its events will
 * bring: so they are told of more cameras and targets than there are. One that insists on the exact
 * number, as levels given one by one do, gets it. Where events bring still more, the policy begins
 * anew and has to learn again.
 */
final class Steering {
  private static final int ROOM_FOR_CAMERAS = 16;
  private static final int ROOM_FOR_TARGETS = 64;

  private final Setup.Policy given;
  private final long seed;
  private ZoomPolicy policy;
  private int[] levels;
  private long earlierMessages;

  Steering(Setup.Policy given, long seed) {
    this.given = given;
    this.seed = seed;
  }

  /**
   * All cameras decide from the same snapshot, then all ranges are set.
   *
   * @throws InputException when the policy does not suit the cameras
   */
  void decide(LiveNetwork network) {
    if (policy == null || network.outgrown()) {
      begin(network);
    }
    for (int camera = 0; camera < levels.length; camera++) {
      levels[camera] = network.level(camera);
    }
    policy.decide(network, levels);
    for (int camera = 0; camera < levels.length; camera++) {
      if (network.online(camera)) {
        network.zoomTo(camera, checked(network, camera));
      }
    }
  }

  /** Rewards the policy for what the cameras saw. */
  void learn(LiveNetwork network) {
    policy.learn(network);
  }

  /** The number of messages that the cameras have sent each other for the policy's sake. */
  long messages() {
    return earlierMessages + (policy == null ? 0 : policy.messages());
  }

  private void begin(LiveNetwork network) {
    earlierMessages = messages();
    policy = begun(network);
    levels = new int[network.cameras()];
  }

  private ZoomPolicy begun(LiveNetwork network) {
    try {
      network.reserve(ROOM_FOR_CAMERAS, ROOM_FOR_TARGETS);
      return newPolicy(network);
    } catch (InputException e) {
      network.reserve(0, ROOM_FOR_TARGETS);
      return newPolicy(network);
    }
  }

  private ZoomPolicy newPolicy(LiveNetwork network) {
    ZoomPolicy made = given.maker().get();
    made.begin(network, new SplittableRandom(seed));
    return made;
  }

  private int checked(LiveNetwork network, int camera) {
    if (levels[camera] < 0 || levels[camera] >= network.levels(camera)) {
      throw new IllegalStateException(
          "policy %s chose level %d for camera %s, expected 0 to %d"
              .formatted(
                  given.spec(),
                  levels[camera],
                  network.cameraName(camera),
                  network.levels(camera) - 1));
    }
    return levels[camera];
  }
}
