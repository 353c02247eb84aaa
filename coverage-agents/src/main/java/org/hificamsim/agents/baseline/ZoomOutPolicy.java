package org.hificamsim.agents.baseline;

import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/** Every camera at its widest level, always (thesis 7.4.2). */
public final class ZoomOutPolicy implements ZoomPolicy {
  public static final String NAME = "zoom-out";

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public void decide(NetworkView network, int[] levels) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      levels[camera] = network.levels(camera) - 1;
    }
  }
}
