package org.hificamsim.core.engine;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.function.ObjIntConsumer;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.Targets;

/**
 * Where a sight finds what it knows of a camera's zoom level: rows, one for each zoom level, with
 * one entry for each size class of targets. Cameras with equal zoom levels share a row.
 */
final class LevelRows {
  private final Cameras cameras;
  private final double[] sizes;
  private final int[] sizeClass;
  private final ObjIntConsumer<ZoomLevel> newRow;
  private final Map<ZoomLevel, Integer> known = new HashMap<>();
  private final int[] firstLevel;
  private final ZoomLevel[] zooms;
  private final int[] rows;
  private final boolean[] allRound;
  private int revision = -1;

  /**
   * No rows yet.
   *
   * @param newRow takes a zoom level and the first entry of its row, when it is met first
   */
  LevelRows(Cameras cameras, Targets targets, ObjIntConsumer<ZoomLevel> newRow) {
    this.cameras = cameras;
    this.newRow = newRow;
    this.sizes = distinctSizes(targets);
    this.sizeClass = new int[targets.count()];
    Arrays.setAll(sizeClass, target -> Arrays.binarySearch(sizes, targets.size(target)));
    this.firstLevel = new int[cameras.count()];
    int levels = 0;
    for (int camera = 0; camera < firstLevel.length; camera++) {
      firstLevel[camera] = levels;
      levels += cameras.levels(camera);
    }
    zooms = new ZoomLevel[levels];
    rows = new int[levels];
    allRound = new boolean[cameras.count()];
  }

  /** Takes note of cameras that changed since the last call. */
  void refresh() {
    if (revision == cameras.revision()) {
      return;
    }
    revision = cameras.revision();
    for (int camera = 0; camera < cameras.count(); camera++) {
      allRound[camera] = cameras.zoom(camera, 0).allRound();
      for (int level = 0; level < cameras.levels(camera); level++) {
        refresh(firstLevel[camera] + level, cameras.zoom(camera, level));
      }
    }
  }

  @SuppressWarnings("ReferenceEquality") // the map below tells equal levels
  private void refresh(int entry, ZoomLevel zoom) {
    if (zooms[entry] != zoom) {
      zooms[entry] = zoom;
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

  /** The first entry of a camera's row at a level. */
  int row(int camera, int level) {
    return rows[firstLevel[camera] + level];
  }

  /** The entry for a camera at a level and a target. */
  int entry(int camera, int level, int target) {
    return row(camera, level) + sizeClass[target];
  }

  /** Whether the camera sees all round. */
  boolean allRound(int camera) {
    return allRound[camera];
  }

  private static double[] distinctSizes(Targets targets) {
    double[] all = new double[targets.count()];
    Arrays.setAll(all, targets::size);
    return Arrays.stream(all).sorted().distinct().toArray();
  }
}
