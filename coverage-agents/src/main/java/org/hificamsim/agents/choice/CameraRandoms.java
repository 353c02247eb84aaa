package org.hificamsim.agents.choice;

import java.util.SplittableRandom;
import org.hificamsim.core.policy.NetworkView;

/**
 * One generator for each camera, so that no camera's draws depend on which others are online or on
 * the order in which they decide.
 */
public final class CameraRandoms {
  private CameraRandoms() {}

  /** Splits {@code random} once per camera of the network, in the order of their numbers. */
  public static SplittableRandom[] split(NetworkView network, SplittableRandom random) {
    SplittableRandom[] randoms = new SplittableRandom[network.cameras()];
    for (int camera = 0; camera < randoms.length; camera++) {
      randoms[camera] = random.split();
    }
    return randoms;
  }
}
