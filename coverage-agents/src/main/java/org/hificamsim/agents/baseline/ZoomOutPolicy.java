package org.hificamsim.agents.baseline;

import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/** Every camera at its widest view, always (thesis 7.4.2). */
public final class ZoomOutPolicy implements ZoomPolicy {
  public static final String NAME = "zoom-out";

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    for (int camera = 0; camera < network.cameras(); camera++) {
      views[camera] = network.views(camera) - 1;
    }
  }
}
