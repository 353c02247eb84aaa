package org.hificamsim.agents.baseline;

import java.util.SplittableRandom;
import org.hificamsim.agents.choice.AbstractDistributedZoomPolicy;
import org.hificamsim.core.policy.NetworkView;

/**
 * Each camera draws its view uniformly in each step (thesis 7.4.2); if moves take time, once it has
 * arrived.
 */
public final class RandomZoomPolicy extends AbstractDistributedZoomPolicy {
  private SplittableRandom[] randoms = {};

  @Override
  public String name() {
    return "random";
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    randoms = split(network, random);
  }

  @Override
  protected int choose(NetworkView network, int camera) {
    return randoms[camera].nextInt(network.views(camera));
  }
}
