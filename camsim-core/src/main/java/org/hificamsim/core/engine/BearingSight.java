package org.hificamsim.core.engine;

import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.SightLines;
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
  private final SightLines lines;
  private final Visibility visibility;
  private final Detection detection;
  private long step;

  BearingSight(World world, Visibility visibility) {
    this.cameras = world.cameras();
    this.targets = world.targets();
    this.lines = world.sightLines();
    this.visibility = visibility;
    this.detection = visibility.detection();
  }

  @Override
  public void refresh(long newStep) {
    step = newStep;
  }

  @Override
  public boolean detects(int camera, int view, int target) {
    Pose pose = cameras.pose(camera, view);
    ZoomLevel zoom = cameras.zoom(camera, view);
    double x = targets.x(target);
    double y = targets.y(target);
    double distance = pose.distance(x, y);
    if (!(distance <= zoom.radius()) || !visibility.isInAngle(pose, zoom, x, y)) {
      return false;
    }
    double through = through(camera, target);
    if (through == 0) {
      return false;
    }
    double cosine = pose.cosine(x, y);
    double luck = visibility.luck(step, camera, target);
    double about = AngleBracket.about(cosine);
    return detects(targets.size(target), distance, cosine, about, zoom, luck, through);
  }

  @Override
  public boolean detectsTurned(int camera, int view, int target) {
    throw new InputException(
        "detection '"
            + detection.name()
            + "' looks at where in the picture a target is, expected one that looks at its"
            + " distance alone for cameras that turn freely");
  }

  @Override
  public double chance(int camera, int view, int target) {
    return visibility.chance(
        cameras.pose(camera, view),
        cameras.zoom(camera, view),
        targets.x(target),
        targets.y(target),
        targets.size(target),
        through(camera, target));
  }

  @Override
  public double value(int camera, int view, int target) {
    return visibility.valueInView(
        cameras.pose(camera, view),
        cameras.zoom(camera, view),
        targets.x(target),
        targets.y(target),
        targets.size(target));
  }

  private double through(int camera, int target) {
    return lines.open() ? 1 : lines.transmittance(camera, target);
  }

  @Override
  public boolean dominates(int camera, int view, int other) {
    return view == other;
  }

  @Override
  public double reach(int camera, int view) {
    return Visibility.roundedUp(cameras.zoom(camera, view).radius());
  }

  /** Distance, luck and what gets through are found once for all views. */
  @Override
  public void mark(
      int camera, int views, PointGrid grid, int from, int to, long[] masks, int words) {
    double widest = cameras.zoom(camera, 0).widestRadius();
    for (int i = from; i < to; i++) {
      double distance = cameras.pose(camera).distance(grid.x(i), grid.y(i));
      int target = grid.point(i);
      double through = distance <= widest ? through(camera, target) : 0;
      if (through > 0) {
        mark(camera, views, target, distance, through, masks, words);
      }
    }
  }

  /** The angle off the axis is found once for each pan angle. */
  private void mark(
      int camera, int views, int target, double distance, double through, long[] masks, int words) {
    double x = targets.x(target);
    double y = targets.y(target);
    double size = targets.size(target);
    double luck = visibility.luck(step, camera, target);
    int zooms = cameras.zooms(camera);
    double cosine = 0;
    double about = 0;
    for (int view = 0; view < views; view++) {
      Pose pose = cameras.pose(camera, view);
      if (view % zooms == 0) {
        cosine = pose.cosine(x, y);
        about = AngleBracket.about(cosine);
      }
      ZoomLevel zoom = cameras.zoom(camera, view);
      if (distance <= zoom.radius()
          && visibility.isInAngle(pose, zoom, x, y)
          && detects(size, distance, cosine, about, zoom, luck, through)) {
        masks[view * words + (target >> 6)] |= 1L << target;
      }
    }
  }

  private boolean detects(
      double size,
      double distance,
      double cosine,
      double about,
      ZoomLevel zoom,
      double luck,
      double through) {
    boolean detects = decides(size, distance, AngleBracket.lower(about), zoom, luck, through);
    return detects == decides(size, distance, AngleBracket.upper(about), zoom, luck, through)
        ? detects
        : decides(size, distance, Math.acos(cosine), zoom, luck, through);
  }

  private boolean decides(
      double size, double distance, double offAxis, ZoomLevel zoom, double luck, double through) {
    double value = detection.model().confidence(size, distance, offAxis, zoom);
    return detection.detects(value, luck, through);
  }
}
