package org.hificamsim.agents.baseline;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/** Every camera at its narrowest view, always: the counterpart of {@link ZoomOutPolicy}. */
public final class ZoomInPolicy implements ZoomPolicy {
  public static final String NAME = "zoom-in";

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    Arrays.fill(views, 0, network.cameras(), 0);
  }
}
