package org.hificamsim.core.engine;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import org.hificamsim.core.detection.DetectedDistances;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/**
 * The sight of models that depend on distance alone: the model is asked once per zoom level and
 * target size, and observing is a test of the squared distance.
 *
 * <p>Reaches are kept per camera, level and size class, in rows of one size class after the other.
 * Nearly all are a single interval, held in two flat arrays; the others are looked up in full.
 */
final class DistanceSight implements Sight {
  private record Key(ZoomLevel zoom, double size) {}

  private final Cameras cameras;
  private final Targets targets;
  private final FieldOfView view;
  private final Detection detection;
  private final double[] sizes;
  private final int[] sizeClass;
  private final int[] firstRow;
  private final Map<Key, DetectedDistances> known = new HashMap<>();
  private final DetectedDistances[] reach;
  private final double[] from;
  private final double[] to;
  private final boolean[] single;
  private final boolean[] allRound;
  private int revision = -1;

  DistanceSight(World world, Detection detection) {
    this.cameras = world.cameras();
    this.targets = world.targets();
    this.view = new FieldOfView(cameras, targets);
    this.detection = detection;
    this.sizes = distinctSizes(targets);
    this.sizeClass = new int[targets.count()];
    Arrays.setAll(sizeClass, target -> Arrays.binarySearch(sizes, targets.size(target)));
    this.firstRow = new int[cameras.count()];
    int rows = 0;
    for (int camera = 0; camera < firstRow.length; camera++) {
      firstRow[camera] = rows;
      rows += cameras.levels(camera) * sizes.length;
    }
    reach = new DetectedDistances[rows];
    from = new double[rows];
    to = new double[rows];
    single = new boolean[rows];
    allRound = new boolean[cameras.count()];
    refresh();
  }

  @Override
  public void refresh() {
    if (revision == cameras.revision()) {
      return;
    }
    revision = cameras.revision();
    for (int camera = 0; camera < cameras.count(); camera++) {
      allRound[camera] = cameras.zoom(camera, 0).viewingAngle() >= 2 * Math.PI;
      for (int level = 0; level < cameras.levels(camera); level++) {
        for (int size = 0; size < sizes.length; size++) {
          fill(firstRow[camera] + level * sizes.length + size, cameras.zoom(camera, level), size);
        }
      }
    }
  }

  @Override
  public boolean detects(int camera, int level, int target) {
    int row = firstRow[camera] + level * sizes.length + sizeClass[target];
    double squared = view.squaredDistance(camera, target);
    if (!(squared >= from[row] && squared <= to[row])) {
      return false;
    }
    return (single[row] || reach[row].contains(squared))
        && (allRound[camera] || view.withinAngle(camera, level, target));
  }

  @Override
  public boolean dominates(int camera, int level, int other) {
    if (cameras.zoom(camera, level).viewingAngle() < cameras.zoom(camera, other).viewingAngle()) {
      return false;
    }
    for (int size = 0; size < sizes.length; size++) {
      DetectedDistances mine = reach[firstRow[camera] + level * sizes.length + size];
      if (!mine.includes(reach[firstRow[camera] + other * sizes.length + size])) {
        return false;
      }
    }
    return true;
  }

  private void fill(int row, ZoomLevel zoom, int size) {
    DetectedDistances set =
        known.computeIfAbsent(
            new Key(zoom, sizes[size]), key -> detection.distances(key.size(), key.zoom()));
    reach[row] = set;
    single[row] = set.intervals() == 1;
    from[row] = set.intervals() == 0 ? Double.POSITIVE_INFINITY : set.from(0);
    to[row] = set.intervals() == 0 ? -1 : set.to(set.intervals() - 1);
  }

  private static double[] distinctSizes(Targets targets) {
    double[] all = new double[targets.count()];
    Arrays.setAll(all, targets::size);
    return Arrays.stream(all).sorted().distinct().toArray();
  }
}
