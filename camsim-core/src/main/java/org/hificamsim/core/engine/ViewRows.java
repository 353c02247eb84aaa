package org.hificamsim.core.engine;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.function.ObjIntConsumer;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.Targets;

/**
 * Where a sight finds what it knows of a camera's view: rows, one for each zoom level, with one
 * entry for each size class of targets. Views with equal zoom levels share a row.
 */
final class ViewRows {
  private final Cameras cameras;
  private final double[] sizes;
  private final int[] sizeClass;
  private final ObjIntConsumer<ZoomLevel> newRow;
  private final Map<ZoomLevel, Integer> known = new HashMap<>();
  private final int[] firstView;
  private final ZoomLevel[] zooms;
  private final int[] rows;
  private final double[] cosines;
  private final boolean[] allRound;
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
    this.firstView = new int[cameras.count()];
    int views = 0;
    for (int camera = 0; camera < firstView.length; camera++) {
      firstView[camera] = views;
      views += cameras.views(camera);
    }
    zooms = new ZoomLevel[views];
    rows = new int[views];
    cosines = new double[views];
    allRound = new boolean[views];
  }

  /** Takes note of cameras that changed since the last call; returns whether any may have. */
  boolean refresh() {
    if (revision == cameras.revision()) {
      return false;
    }
    revision = cameras.revision();
    for (int camera = 0; camera < cameras.count(); camera++) {
      for (int view = 0; view < cameras.views(camera); view++) {
        refresh(firstView[camera] + view, cameras.zoom(camera, view));
      }
    }
    return true;
  }

  @SuppressWarnings("ReferenceEquality") // the map below tells equal levels
  private void refresh(int entry, ZoomLevel zoom) {
    if (zooms[entry] != zoom) {
      zooms[entry] = zoom;
      allRound[entry] = zoom.allRound();
      cosines[entry] = Math.cos(zoom.viewingAngle() / 2);
      rows[entry] = known.computeIfAbsent(zoom, this::add);
    }
  }

  private int add(ZoomLevel zoom) {
    int row = known.size() * sizes.length;
    newRow.accept(zoom, row);
    return row;
  }

  /** The number of size classes: the entries of a row. */
  int sizes() {
    return sizes.length;
  }

  /** The size of a class, metres. */
  double size(int of) {
    return sizes[of];
  }

  /** How many views all cameras have. */
  int views() {
    return rows.length;
  }

  /** The number of a camera's view among those of all cameras. */
  int number(int camera, int view) {
    return firstView[camera] + view;
  }

  /** The first entry of the row of a view, by its number. */
  int row(int number) {
    return rows[number];
  }

  /** Whether a camera sees all round in a view, by its number. */
  boolean allRound(int number) {
    return allRound[number];
  }

  /** The first entry of a camera's row at a view. */
  int row(int camera, int view) {
    return rows[firstView[camera] + view];
  }

  /** The entry for a camera at a view and a target. */
  int entry(int camera, int view, int target) {
    return row(camera, view) + sizeClass[target];
  }

  /** Whether the camera sees all round in a view. */
  boolean allRound(int camera, int view) {
    return allRound[firstView[camera] + view];
  }

  /** The cosine of half the opening angle of a view. */
  double cosine(int camera, int view) {
    return cosines[firstView[camera] + view];
  }

  private static double[] distinctSizes(Targets targets) {
    double[] all = new double[targets.count()];
    Arrays.setAll(all, targets::size);
    return Arrays.stream(all).sorted().distinct().toArray();
  }
}
