package org.hificamsim.runs.heat;

import java.util.Arrays;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.VisibleRegion;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.visibility.Visibility;

/**
 * What each camera sees of the cells in each of its views. It is found when a view is first used,
 * and kept until a camera is moved, or until there is too much of it.
 */
final class ViewCells {
  /** Cells that are kept of all views together: 50 MB. */
  private static final int MAX_KEPT = 1 << 22;

  private final FieldCells cells;
  private final Visibility visibility;
  private final Obstacles obstacles;
  private final double size;
  private VisibleRegion[] regions = {};
  private SeenCells[][] seen = {};
  private double[][] pans = {};
  private long kept;

  ViewCells(FieldCells cells, Detection detection, Obstacles obstacles, double size) {
    this.cells = cells;
    this.visibility = Visibility.of(detection);
    this.obstacles = obstacles;
    this.size = size;
  }

  /** Forgets everything, as cameras are elsewhere now. */
  void forget(NetworkView network) {
    regions = new VisibleRegion[network.cameras()];
    seen = new SeenCells[network.cameras()][];
    pans = new double[network.cameras()][];
    kept = 0;
  }

  /**
   * What a camera sees through one of its views.
   *
   * @param view -1 for a camera that sees nothing
   */
  SeenCells of(NetworkView network, int camera, int view) {
    if (view < 0) {
      return SeenCells.NONE;
    }
    if (kept > MAX_KEPT) {
      forget(network);
    }
    if (seen[camera] == null) {
      seen[camera] = new SeenCells[network.views(camera)];
      pans[camera] = new double[network.views(camera)];
      Arrays.fill(pans[camera], Double.NaN);
    }
    double pan = network.pan(camera, view);
    if (pans[camera][view] != pan) {
      pans[camera][view] = pan;
      seen[camera][view] = find(network, camera, view, pan);
      kept += seen[camera][view].cells().length;
    }
    return seen[camera][view];
  }

  private SeenCells find(NetworkView network, int camera, int view, double pan) {
    double x = network.cameraX(camera);
    double y = network.cameraY(camera);
    Pose pose = Pose.of(x, y, network.cameraHeading(camera)).turned(pan);
    if (regions[camera] == null && !obstacles.isEmpty()) {
      regions[camera] = VisibleRegion.of(obstacles, x, y);
    }
    return SeenCells.of(cells, visibility, pose, network.zoom(camera, view), regions[camera], size);
  }
}
