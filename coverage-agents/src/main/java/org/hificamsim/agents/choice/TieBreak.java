package org.hificamsim.agents.choice;

import java.util.stream.IntStream;
import org.hificamsim.core.policy.NetworkView;

/**
 * How each camera decides between equally good views: it looks ahead, at its widest or narrowest
 * zoom level, where that is one of them; otherwise {@link Ties} decides by the views' numbers.
 */
public final class TieBreak {
  private final Ties ties;
  private final int[] ahead;

  public TieBreak(Ties ties, NetworkView network) {
    this.ties = ties;
    ahead = IntStream.range(0, network.cameras()).map(camera -> ahead(network, camera)).toArray();
  }

  private int ahead(NetworkView network, int camera) {
    int zoom = ties.best(network.zooms(camera));
    return network.viewAt(camera, PanAngles.home(network, camera), zoom);
  }

  /** The camera's view where all are equally good. */
  public int best(int camera) {
    return ahead[camera];
  }

  /** The camera's view with the largest value, see {@link Ties#best(double[], int, int)}. */
  public int best(int camera, double[] values, int from, int views) {
    return ties.best(values, from, views, ahead[camera]);
  }
}
