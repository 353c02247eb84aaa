package org.hificamsim.agents.baseline;

import java.util.SplittableRandom;
import org.hificamsim.agents.choice.CameraRandoms;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/** A level drawn uniformly for each camera at each step (section 7.4.2). */
public final class RandomZoomPolicy implements ZoomPolicy {
  public static final String NAME = "random";

  private SplittableRandom[] randoms = {};

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    randoms = CameraRandoms.split(network, random);
  }

  @Override
  public void decide(NetworkView network, int[] levels) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      if (network.online(camera)) {
        levels[camera] = randoms[camera].nextInt(network.levels(camera));
      }
    }
  }
}
