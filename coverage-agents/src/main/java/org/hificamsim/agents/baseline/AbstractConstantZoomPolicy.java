package org.hificamsim.agents.baseline;

import java.util.SplittableRandom;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/** A policy whose cameras each have one view, always. */
abstract class AbstractConstantZoomPolicy implements ZoomPolicy {
  private int[] constant = {};

  /** The camera's view. */
  protected abstract int view(NetworkView network, int camera);

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    constant = new int[network.cameras()];
    for (int camera = 0; camera < constant.length; camera++) {
      constant[camera] = view(network, camera);
    }
  }

  @Override
  public final void decide(NetworkView network, int[] views) {
    System.arraycopy(constant, 0, views, 0, constant.length);
  }
}
