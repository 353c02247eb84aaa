package org.hificamsim.agents.baseline;

import java.util.Arrays;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/** Every camera at its narrowest level, always: the counterpart of {@link ZoomOutPolicy}. */
public final class ZoomInPolicy implements ZoomPolicy {
  public static final String NAME = "zoom-in";

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public void decide(NetworkView network, int[] levels) {
    Arrays.fill(levels, 0, network.cameras(), 0);
  }
}
