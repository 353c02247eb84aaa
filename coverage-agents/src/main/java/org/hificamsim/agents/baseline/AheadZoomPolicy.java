package org.hificamsim.agents.baseline;

import java.util.SplittableRandom;
import org.hificamsim.agents.choice.PanAngles;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * Every camera looks ahead at one of its zoom levels, always: at the widest ({@code zoom-out},
 * thesis 7.4.2) or at the narrowest ({@code zoom-in}). Ahead is the pan angle that is nearest to
 * how it is mounted.
 */
public final class AheadZoomPolicy implements ZoomPolicy {
  private final String name;
  private final PatrolZoomPolicy.Zoom zoom;
  private int[] ahead = {};

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
    ahead = new int[network.cameras()];
    for (int camera = 0; camera < ahead.length; camera++) {
      int pan = PanAngles.home(network, camera);
      ahead[camera] = network.viewAt(camera, pan, zoom.of(network.zooms(camera)));
    }
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    System.arraycopy(ahead, 0, views, 0, ahead.length);
  }
}
