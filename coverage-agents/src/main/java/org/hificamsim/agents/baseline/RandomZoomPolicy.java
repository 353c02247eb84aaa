package org.hificamsim.agents.baseline;

import java.util.SplittableRandom;
import org.hificamsim.agents.choice.CameraRandoms;
import org.hificamsim.core.policy.CameraTask;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/** A level drawn uniformly for each camera at each step (section 7.4.2). */
public final class RandomZoomPolicy implements ZoomPolicy {
  public static final String NAME = "random";

  private final CameraTask<int[]> deciding = this::decide;
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
    network.divide(levels, deciding);
  }

  private void decide(NetworkView network, int[] levels, int from, int to) {
    for (int camera = from; camera < to; camera++) {
      if (network.online(camera)) {
        levels[camera] = randoms[camera].nextInt(network.levels(camera));
      }
    }
  }
}
