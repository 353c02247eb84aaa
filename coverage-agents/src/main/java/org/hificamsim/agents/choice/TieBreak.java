package org.hificamsim.agents.choice;

import java.util.stream.IntStream;
import org.hificamsim.core.policy.NetworkView;

/**
 * Decides between equally good views of a camera. If the view ahead at its widest or narrowest zoom
 * level is one of them, the camera takes it; otherwise {@link Ties} decides by the views' numbers.
 */
public final class TieBreak {
  private final Ties ties;
  private final int[] aheadViews;

  public TieBreak(Ties ties, NetworkView network) {
    this.ties = ties;
    aheadViews =
        IntStream.range(0, network.cameras()).map(camera -> aheadView(network, camera)).toArray();
  }

  private int aheadView(NetworkView network, int camera) {
    int zoom = ties.best(network.zooms(camera));
    return network.viewAt(camera, PanAngles.home(network, camera), zoom);
  }

  /** Returns the camera's view when all are equally good. */
  public int best(int camera) {
    return aheadViews[camera];
  }

  /**
   * Returns the camera's view with the greatest value, see {@link Ties#best(double[], int, int)}.
   */
  public int best(int camera, double[] values, int from, int views) {
    return ties.best(values, from, views, aheadViews[camera]);
  }
}
