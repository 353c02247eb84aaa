package org.hificamsim.agents.baseline;

import java.util.SplittableRandom;
import org.hificamsim.agents.choice.PanAngles;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * Every camera always looks ahead at the same zoom level: the widest ({@code zoom-out}, thesis
 * 7.4.2) or the narrowest ({@code zoom-in}). Ahead is the pan angle nearest to the camera's
 * heading.
 */
public final class AheadZoomPolicy implements ZoomPolicy {
  private final String name;
  private final PatrolZoomPolicy.Zoom zoom;
  private int[] aheadViews = {};

  public AheadZoomPolicy(String name, PatrolZoomPolicy.Zoom zoom) {
    this.name = name;
    this.zoom = zoom;
  }

  @Override
  public String name() {
    return name;
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    aheadViews = new int[network.cameras()];
    for (int camera = 0; camera < aheadViews.length; camera++) {
      int pan = PanAngles.home(network, camera);
      aheadViews[camera] = network.viewAt(camera, pan, zoom.number(network.zooms(camera)));
    }
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    System.arraycopy(aheadViews, 0, views, 0, aheadViews.length);
  }
}
