package org.hificamsim.agents.baseline;

import org.hificamsim.agents.choice.PanAngles;
import org.hificamsim.core.policy.NetworkView;

/**
 * Every camera looks ahead at its widest zoom level, always (thesis 7.4.2). Ahead is the pan angle
 * that is nearest to how it is mounted.
 */
public final class ZoomOutPolicy extends AbstractConstantZoomPolicy {
  public static final String NAME = "zoom-out";

  @Override
  public String name() {
    return NAME;
  }

  @Override
  protected int view(NetworkView network, int camera) {
    return PanAngles.widest(network, camera, PanAngles.home(network, camera));
  }
}
