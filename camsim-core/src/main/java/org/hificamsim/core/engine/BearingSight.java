package org.hificamsim.core.engine;

import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.world.World;

/** The sight of models that depend on the bearing: the model is called in full. */
final class BearingSight implements Sight {
  private final World world;
  private final FieldOfView view;
  private final Detection detection;

  BearingSight(World world, Detection detection) {
    this.world = world;
    this.view = new FieldOfView(world.cameras(), world.targets());
    this.detection = detection;
  }

  @Override
  public void refresh() {}

  @Override
  public boolean detects(int camera, int level, int target) {
    if (!view.contains(camera, level, target)) {
      return false;
    }
    ZoomLevel zoom = world.cameras().zoom(camera, level);
    double distance = Math.sqrt(view.squaredDistance(camera, target));
    return detects(target, distance, view.offAxis(camera, target), zoom);
  }

  @Override
  public boolean dominates(int camera, int level, int other) {
    return level == other;
  }

  @Override
  public double reach(int camera, int level) {
    return Reach.of(world.cameras().zoom(camera, level).radius());
  }

  /** Distance and angle are computed once for all levels. */
  @Override
  public void mark(
      int camera, int levels, PointGrid targets, int from, int to, long[] masks, int words) {
    for (int i = from; i < to; i++) {
      int target = targets.point(i);
      double distance = Math.sqrt(view.squaredDistance(camera, target));
      if (!(distance <= world.cameras().zoom(camera, 0).widestRadius())) {
        continue;
      }
      double offAxis = Double.NaN;
      boolean known = false;
      for (int level = 0; level < levels; level++) {
        ZoomLevel zoom = world.cameras().zoom(camera, level);
        if (distance <= zoom.radius() && view.withinAngle(camera, level, target)) {
          offAxis = known ? offAxis : view.offAxis(camera, target);
          known = true;
          if (detects(target, distance, offAxis, zoom)) {
            masks[level * words + (target >> 6)] |= 1L << target;
          }
        }
      }
    }
  }

  private boolean detects(int target, double distance, double offAxis, ZoomLevel zoom) {
    return detection.model().confidence(world.targets().size(target), distance, offAxis, zoom)
        >= detection.threshold();
  }
}
