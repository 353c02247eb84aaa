package org.hificamsim.core.engine;

import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.World;

/**
 * The sight of models that depend on the bearing: the model is called in full.
 *
 * <p>The arc cosine is what costs most, so the model is asked at two angles that have the target's
 * between them, {@value AngleBracket#ERROR} radians to either side. Where it decides alike at both,
 * that is the decision; a beam thinner than this is not seen.
 */
final class BearingSight implements Sight {
  private final World world;
  private final Cameras cameras;
  private final FieldOfView view;
  private final Detection detection;

  BearingSight(World world, Detection detection) {
    this.world = world;
    this.cameras = world.cameras();
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
    double distance = Math.sqrt(view.squaredDistance(camera, target));
    double cosine = view.cosine(camera, target);
    return detects(
        target, distance, cosine, AngleBracket.near(cosine), cameras.zoom(camera, level));
  }

  @Override
  public boolean dominates(int camera, int level, int other) {
    return level == other;
  }

  @Override
  public double reach(int camera, int level) {
    return Reach.of(cameras.zoom(camera, level).radius());
  }

  /** Distance and cosine are computed once for all levels. */
  @Override
  public void mark(
      int camera, int levels, PointGrid targets, int from, int to, long[] masks, int words) {
    double widest = cameras.zoom(camera, 0).widestRadius();
    for (int i = from; i < to; i++) {
      int target = targets.point(i);
      double distance = Math.sqrt(view.squaredDistance(camera, target));
      if (!(distance <= widest)) {
        continue;
      }
      double cosine = view.cosine(camera, target);
      double near = AngleBracket.near(cosine);
      for (int level = 0; level < levels; level++) {
        ZoomLevel zoom = cameras.zoom(camera, level);
        if (distance <= zoom.radius()
            && view.withinAngle(camera, level, target)
            && detects(target, distance, cosine, near, zoom)) {
          masks[level * words + (target >> 6)] |= 1L << target;
        }
      }
    }
  }

  private boolean detects(int target, double distance, double cosine, double near, ZoomLevel zoom) {
    double size = world.targets().size(target);
    boolean detects = decides(size, distance, AngleBracket.least(near), zoom);
    return detects == decides(size, distance, AngleBracket.most(near), zoom)
        ? detects
        : decides(size, distance, Math.acos(cosine), zoom);
  }

  private boolean decides(double size, double distance, double offAxis, ZoomLevel zoom) {
    return detection.model().confidence(size, distance, offAxis, zoom) >= detection.threshold();
  }
}
