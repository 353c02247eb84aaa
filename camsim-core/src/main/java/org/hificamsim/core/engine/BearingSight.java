package org.hificamsim.core.engine;

import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/**
 * The sight of models that depend on the bearing: the model is called in full.
 *
 * <p>The arc cosine is what costs most, so the model is asked at two angles that have the target's
 * between them, {@value AngleBracket#ERROR} radians to either side. Where it decides alike at both,
 * that is the decision; a beam thinner than this is not seen.
 */
final class BearingSight implements Sight {
  private final Cameras cameras;
  private final Targets targets;
  private final Visibility visibility;
  private final Detection detection;
  private long step;

  BearingSight(World world, Visibility visibility) {
    this.cameras = world.cameras();
    this.targets = world.targets();
    this.visibility = visibility;
    this.detection = visibility.detection();
  }

  @Override
  public void refresh(long newStep) {
    step = newStep;
  }

  @Override
  public boolean detects(int camera, int view, int target) {
    Pose pose = cameras.pose(camera);
    ZoomLevel zoom = cameras.zoom(camera, view);
    double x = targets.x(target);
    double y = targets.y(target);
    double distance = pose.distance(x, y);
    if (!(distance <= zoom.radius()) || !visibility.isInAngle(pose, zoom, x, y)) {
      return false;
    }
    double cosine = pose.cosine(x, y);
    double luck = visibility.luck(step, camera, target);
    return detects(targets.size(target), distance, cosine, AngleBracket.about(cosine), zoom, luck);
  }

  @Override
  public double chance(int camera, int view, int target) {
    return visibility.chance(
        cameras.pose(camera),
        cameras.zoom(camera, view),
        targets.x(target),
        targets.y(target),
        targets.size(target));
  }

  @Override
  public boolean dominates(int camera, int view, int other) {
    return view == other;
  }

  @Override
  public double reach(int camera, int view) {
    return Sight.roundedUp(cameras.zoom(camera, view).radius());
  }

  /** Distance and cosine are computed once for all views. */
  @Override
  public void mark(
      int camera, int views, PointGrid grid, int from, int to, long[] masks, int words) {
    Pose pose = cameras.pose(camera);
    double widest = cameras.zoom(camera, 0).widestRadius();
    for (int i = from; i < to; i++) {
      double x = grid.x(i);
      double y = grid.y(i);
      double distance = pose.distance(x, y);
      if (!(distance <= widest)) {
        continue;
      }
      int target = grid.point(i);
      double size = targets.size(target);
      double cosine = pose.cosine(x, y);
      double about = AngleBracket.about(cosine);
      double luck = visibility.luck(step, camera, target);
      for (int view = 0; view < views; view++) {
        ZoomLevel zoom = cameras.zoom(camera, view);
        if (distance <= zoom.radius()
            && visibility.isInAngle(pose, zoom, x, y)
            && detects(size, distance, cosine, about, zoom, luck)) {
          masks[view * words + (target >> 6)] |= 1L << target;
        }
      }
    }
  }

  private boolean detects(
      double size, double distance, double cosine, double about, ZoomLevel zoom, double luck) {
    boolean detects = decides(size, distance, AngleBracket.lower(about), zoom, luck);
    return detects == decides(size, distance, AngleBracket.upper(about), zoom, luck)
        ? detects
        : decides(size, distance, Math.acos(cosine), zoom, luck);
  }

  private boolean decides(
      double size, double distance, double offAxis, ZoomLevel zoom, double luck) {
    return detection.detects(detection.model().confidence(size, distance, offAxis, zoom), luck);
  }
}
