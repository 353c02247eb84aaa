package org.hificamsim.agents.baseline;

import java.util.SplittableRandom;
import org.hificamsim.agents.choice.AbstractDistributedZoomPolicy;
import org.hificamsim.core.policy.NetworkView;

/**
 * A view drawn uniformly for each camera at each step (thesis 7.4.2); where moves take time, for
 * each camera that has arrived.
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
