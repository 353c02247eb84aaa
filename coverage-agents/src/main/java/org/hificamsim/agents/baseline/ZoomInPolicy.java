package org.hificamsim.agents.baseline;

import org.hificamsim.agents.choice.PanAngles;
import org.hificamsim.core.policy.NetworkView;

/**
 * Every camera looks ahead at its narrowest zoom level, always: the counterpart of {@link
 * ZoomOutPolicy}.
 */
public final class ZoomInPolicy extends AbstractConstantZoomPolicy {
  public static final String NAME = "zoom-in";

  @Override
  public String name() {
    return NAME;
  }

  @Override
  protected int view(NetworkView network, int camera) {
    return PanAngles.view(network, camera, PanAngles.home(network, camera), 0);
  }
}
