package org.hificamsim.core.engine;

import java.util.Arrays;
import java.util.function.ObjIntConsumer;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.Targets;

/**
 * Where a sight finds what it knows of a camera's view: rows, one for each zoom level by its
 * number, with one entry for each size class of targets.
 */
final class ViewRows {
  private final Cameras cameras;
  private final double[] sizes;
  private final int[] sizeClass;
  private final ObjIntConsumer<ZoomLevel> newRow;
  private ZoomLevel[] zooms = {}; // by number
  private double[] cosines = {}; // likewise
  private boolean[] allRound = {}; // likewise
  private int revision = -1;

  /**
   * No rows yet.
   *
   * @param newRow takes a zoom level and the first entry of its row, when it is met first
   */
  ViewRows(Cameras cameras, Targets targets, ObjIntConsumer<ZoomLevel> newRow) {
    this.cameras = cameras;
    this.newRow = newRow;
    this.sizes = distinctSizes(targets);
    this.sizeClass = new int[targets.count()];
    Arrays.setAll(sizeClass, target -> Arrays.binarySearch(sizes, targets.size(target)));
  }

  /** Takes note of cameras that changed since the last call. */
  void refresh() {
    if (revision == cameras.revision()) {
      return;
    }
    revision = cameras.revision();
    for (int camera = 0; camera < cameras.count(); camera++) {
      for (int view = 0; view < cameras.views(camera); view++) {
        int number = cameras.zoomNumber(camera, view);
        if (number >= zooms.length || zooms[number] == null) {
          add(number, cameras.zoom(camera, view));
        }
      }
    }
  }

  private void add(int number, ZoomLevel zoom) {
    if (number >= zooms.length) {
      int length = Math.max(number + 1, 2 * zooms.length);
      zooms = Arrays.copyOf(zooms, length);
      cosines = Arrays.copyOf(cosines, length);
      allRound = Arrays.copyOf(allRound, length);
    }
    zooms[number] = zoom;
    cosines[number] = Math.cos(zoom.viewingAngle() / 2);
    allRound[number] = zoom.allRound();
    newRow.accept(zoom, number * sizes.length);
  }

  /** The number of size classes: the entries of a row. */
  int sizes() {
    return sizes.length;
  }

  /** The size of a class, metres. */
  double size(int of) {
    return sizes[of];
  }

  /** The first entry of a camera's row at a view. */
  int row(int camera, int view) {
    return cameras.zoomNumber(camera, view) * sizes.length;
  }

  /** The entry for a camera at a view and a target. */
  int entry(int camera, int view, int target) {
    return row(camera, view) + sizeClass[target];
  }

  /** Whether the camera sees all round in a view. */
  boolean allRound(int camera, int view) {
    return allRound[cameras.zoomNumber(camera, view)];
  }

  /** The cosine of half the opening angle of a view. */
  double cosine(int camera, int view) {
    return cosines[cameras.zoomNumber(camera, view)];
  }

  private static double[] distinctSizes(Targets targets) {
    double[] all = new double[targets.count()];
    Arrays.setAll(all, targets::size);
    return Arrays.stream(all).sorted().distinct().toArray();
  }
}
