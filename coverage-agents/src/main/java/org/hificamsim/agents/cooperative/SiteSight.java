package org.hificamsim.agents.cooperative;

import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.VisibleRegion;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.visibility.Body;

/**
 * What cameras would see by the map that they have of the site: exact sight, past the obstacles
 * that are on the map, whatever is there.
 */
final class SiteSight {
  private final Obstacles map;
  private final VisibleRegion[] regions;
  private int revision = -1;

  SiteSight(Obstacles map, int cameras) {
    this.map = map;
    this.regions = new VisibleRegion[cameras];
  }

  /** Takes note of cameras that were added or moved; returns whether there are any. */
  boolean refresh(NetworkView network) {
    if (revision == network.revision()) {
      return false;
    }
    revision = network.revision();
    boolean moved = false;
    for (int camera = 0; camera < regions.length; camera++) {
      double x = network.cameraX(camera);
      double y = network.cameraY(camera);
      if (regions[camera] == null || !regions[camera].isFrom(x, y)) {
        regions[camera] = VisibleRegion.of(map, x, y);
        moved = true;
      }
    }
    return moved;
  }

  /** As {@link NetworkView#chancesAt}, past the obstacles of the map. */
  boolean chances(
      NetworkView network, int camera, double x, double y, double size, double[] chances) {
    double z = network.zoom(camera, 0).vertical().z();
    Body body = network.body(size);
    double through = regions[camera].transmittance(x, y, z, body.low(), body.high());
    return through > 0 && network.chancesAt(camera, x, y, size, through, chances);
  }

  /** Whether a target could go straight from one place to another. */
  boolean isWay(double fromX, double fromY, double toX, double toY) {
    return map.clear(fromX, fromY, toX, toY);
  }

  /** Whether a target could be at a place. */
  boolean isFree(double x, double y) {
    return map.containing(x, y).isEmpty();
  }
}
