package org.hificamsim.core.engine;

import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/** Keeps every camera at its widest view. */
public final class WidestPolicy implements ZoomPolicy {
  @Override
  public String name() {
    return "widest";
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    for (int camera = 0; camera < views.length; camera++) {
      views[camera] = network.views(camera) - 1;
    }
  }
}
