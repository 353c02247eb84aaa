package org.hificamsim.core.engine;

import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/** Every camera at its widest level. */
public final class WidestPolicy implements ZoomPolicy {
  @Override
  public String name() {
    return "widest";
  }

  @Override
  public void decide(NetworkView network, int[] levels) {
    for (int camera = 0; camera < levels.length; camera++) {
      levels[camera] = network.levels(camera) - 1;
    }
  }
}
