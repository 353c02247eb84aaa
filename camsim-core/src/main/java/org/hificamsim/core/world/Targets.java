package org.hificamsim.core.world;

import java.util.Random;
import org.hificamsim.core.detection.Seen;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.TargetOcclusion;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.StepOrder;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.visibility.Body;

/**
 * The state of the targets: one array for each quantity, sized for all targets that the scenario
 * will ever have.
 *
 * <p>A target keeps its number. A target is present from its appearance to its removal.
 */
public final class Targets {
  private final Field field;
  private final Obstacles obstacles;
  private final String[] names;
  private final double[] x;
  private final double[] y;
  private final double[] heading;
  private final double[] speed;
  private final double[] size;
  private final double[] width;
  private final double[] height;

  /** The part of each target that has to be seen; null for the common rule. */
  private final Seen[] seen;

  /** The radius of the disc by which each target hides others, in metres; 0 while it is absent. */
  private final double[] occlusionRadius;

  private final boolean[] present;
  private final boolean movesFirst;
  private Seen commonSeen = Seen.WHOLE;
  private boolean foreshortened;
  private boolean byHeight;

  Targets(Field field, Obstacles obstacles, StepOrder order, int count) {
    movesFirst = order == StepOrder.CAMSIM;
    this.field = field;
    this.obstacles = obstacles;
    names = new String[count];
    x = new double[count];
    y = new double[count];
    heading = new double[count];
    speed = new double[count];
    size = new double[count];
    width = new double[count];
    height = new double[count];
    seen = new Seen[count];
    occlusionRadius = new double[count];
    present = new boolean[count];
  }

  /** Defines a target that has not appeared yet. */
  void define(int target, TargetSpec spec) {
    names[target] = spec.name();
    size[target] = spec.size();
    width[target] = spec.width();
    height[target] = spec.height();
    seen[target] = spec.seen().orElse(null);
    disappear(target);
    x[target] = 0;
    y[target] = 0;
    heading[target] = 0;
    speed[target] = 0;
  }

  void appear(int target, double newX, double newY, double newHeading, double newSpeed) {
    x[target] = newX;
    y[target] = newY;
    heading[target] = newHeading;
    speed[target] = newSpeed;
    occlusionRadius[target] = width[target] / 2;
    present[target] = true;
  }

  void rename(int target, String name) {
    names[target] = name;
  }

  void disappear(int target) {
    occlusionRadius[target] = 0;
    present[target] = false;
  }

  /** The number of targets that there will ever be. */
  public int count() {
    return x.length;
  }

  /** The target's name in result files: its features value, as CamSim prints it. */
  public String name(int target) {
    return names[target];
  }

  /** Whether the target has appeared and not been removed. */
  public boolean present(int target) {
    return present[target];
  }

  /** The x coordinate, in metres. */
  public double x(int target) {
    return x[target];
  }

  /** The y coordinate, in metres. */
  public double y(int target) {
    return y[target];
  }

  /** The heading, in radians: 0 is +y and pi/2 is +x; not normalised. */
  public double heading(int target) {
    return heading[target];
  }

  /** The speed, metres per step. */
  public double speed(int target) {
    return speed[target];
  }

  /** Returns the edge q of the bounding box, in metres. */
  public double size(int target) {
    return size[target];
  }

  /** The width of the target, seen from above, in metres. */
  public double width(int target) {
    return width[target];
  }

  /** The height of the target, in metres. */
  public double height(int target) {
    return height[target];
  }

  /** The size of the target as the detection model takes it: its size or its height, in metres. */
  public double seenSize(int target) {
    return byHeight ? height[target] : size[target];
  }

  /** Sets what must be seen of targets that have no rule of their own, and which size counts. */
  void setRule(Seen newCommonSeen, boolean foreshortened, boolean byHeight) {
    commonSeen = newCommonSeen;
    this.foreshortened = foreshortened;
    this.byHeight = byHeight;
  }

  private Seen seen(int target) {
    return seen[target] == null ? commonSeen : seen[target];
  }

  /** The lowest height of the target that must be seen, in metres. */
  public double low(int target) {
    return seen(target).low(height[target]);
  }

  /** The greatest height of the target that must be seen, in metres. */
  public double high(int target) {
    return seen(target).high(height[target]);
  }

  /** The part of the target that a camera with a height must see. */
  public Body body(int target) {
    return new Body(seenSize(target), low(target), high(target), foreshortened);
  }

  /** The mean width of all targets so far, in metres; 0 if there are none. */
  double meanWidth() {
    double sum = 0;
    int known = 0;
    for (double targetWidth : width) {
      sum += targetWidth;
      known += targetWidth > 0 ? 1 : 0;
    }
    return sum / Math.max(1, known);
  }

  /**
   * Whether another target hides this one from a point, in metres; fromZ is NaN in a flat world.
   */
  boolean isHidden(int target, double fromX, double fromY, double fromZ) {
    return TargetOcclusion.hidden(
        fromX, fromY, fromZ, target, x, y, occlusionRadius, height, low(target), high(target));
  }

  /** Turns the target. */
  public void turnTo(int target, double newHeading) {
    heading[target] = newHeading;
  }

  /** Changes the target's speed. */
  public void accelerateTo(int target, double newSpeed) {
    speed[target] = newSpeed;
  }

  /** Puts the target at a point, even outside the field. */
  public void put(int target, double newX, double newY) {
    x[target] = newX;
    y[target] = newY;
  }

  /** The field that targets move in. */
  public Field field() {
    return field;
  }

  /** Whether targets move before cameras look, even in the step in which they appear. */
  public boolean moveFirst() {
    return movesFirst;
  }

  /** Whether the target can walk straight to a point: glass and raised obstacles do not stop it. */
  public boolean canWalk(int target, double toX, double toY) {
    return obstacles.isEmpty() || obstacles.clear(x[target], y[target], toX, toY);
  }

  /**
   * Moves the target by (dx, dy). If that leads out of the field or through an obstacle, the move
   * is undone and the target turns by pi + (2u - 1) pi/6. As in CamSim, the move is subtracted
   * again, so that the last bits of the position may differ.
   *
   * @param turn the stream that u is drawn from
   * @return whether the target moved
   */
  public boolean advance(int target, double dx, double dy, Random turn) {
    boolean free = canWalk(target, x[target] + dx, y[target] + dy);
    x[target] += dx;
    y[target] += dy;
    if (free && field.contains(x[target], y[target])) {
      return true;
    }
    heading[target] += Math.PI + ((turn.nextDouble() * 2 - 1) * Math.PI) / 6;
    x[target] -= dx;
    y[target] -= dy;
    return false;
  }
}
