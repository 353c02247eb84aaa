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
 * The targets' state, one array a quantity, sized once for all targets that will ever appear.
 *
 * <p>A target keeps its number; one that has not appeared yet, or has disappeared, is not present.
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
  private final Seen[] seen; // null for what counts for all
  private final double[] radius; // of what hides others: 0 where the target is not present
  private final boolean[] present;
  private final boolean movesFirst;
  private Seen usual = Seen.WHOLE;
  private boolean foreshortened;

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
    radius = new double[count];
    present = new boolean[count];
  }

  /** Not there yet. */
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

  void appear(int target, double atX, double atY, double itsHeading, double itsSpeed) {
    x[target] = atX;
    y[target] = atY;
    heading[target] = itsHeading;
    speed[target] = itsSpeed;
    radius[target] = width[target] / 2;
    present[target] = true;
  }

  void rename(int target, String name) {
    names[target] = name;
  }

  void disappear(int target) {
    radius[target] = 0;
    present[target] = false;
  }

  /** How many targets there will ever be. */
  public int count() {
    return x.length;
  }

  /** The name in result files: the features value, as CamSim prints it. */
  public String name(int target) {
    return names[target];
  }

  /** Whether the target has appeared and not been removed. */
  public boolean present(int target) {
    return present[target];
  }

  /** Metres. */
  public double x(int target) {
    return x[target];
  }

  /** Metres. */
  public double y(int target) {
    return y[target];
  }

  /** Radians, 0 is +y and pi/2 is +x; not normalised. */
  public double heading(int target) {
    return heading[target];
  }

  /** Metres per step. */
  public double speed(int target) {
    return speed[target];
  }

  /** Edge of the bounding box q, metres. */
  public double size(int target) {
    return size[target];
  }

  /** How wide it is, seen from above, metres. */
  public double width(int target) {
    return width[target];
  }

  /** Says what has to be seen of targets that say nothing. */
  void require(Seen usual, boolean foreshortened) {
    this.usual = usual;
    this.foreshortened = foreshortened;
  }

  private Seen seen(int target) {
    return seen[target] == null ? usual : seen[target];
  }

  /** The least height that has to be seen of the target, metres. */
  public double low(int target) {
    return seen(target).low(height[target]);
  }

  /** The greatest, metres. */
  public double high(int target) {
    return seen(target).high(height[target]);
  }

  /** What of the target a camera with a height has to see. */
  public Body body(int target) {
    return new Body(size[target], low(target), high(target), foreshortened);
  }

  /**
   * Whether another target hides this one from a point; metres, a height of NaN in a flat world.
   */
  boolean isHidden(int target, double fromX, double fromY, double fromZ) {
    return TargetOcclusion.hidden(
        fromX, fromY, fromZ, target, x, y, radius, height, low(target), high(target));
  }

  /** Turns the target. */
  public void turnTo(int target, double newHeading) {
    heading[target] = newHeading;
  }

  /** Changes the target's speed. */
  public void accelerateTo(int target, double newSpeed) {
    speed[target] = newSpeed;
  }

  /** Puts the target on a point, without regard to the field's border. */
  public void put(int target, double newX, double newY) {
    x[target] = newX;
    y[target] = newY;
  }

  /** The field that targets move in. */
  public Field field() {
    return field;
  }

  /** Whether targets move before the cameras look, also in the step in which they appear. */
  public boolean moveFirst() {
    return movesFirst;
  }

  /** Whether a target may walk from where it is to a point: no obstacle is in its way. */
  public boolean canWalk(int target, double toX, double toY) {
    return obstacles.isEmpty() || obstacles.clear(x[target], y[target], toX, toY);
  }

  /**
   * Moves the target by (dx, dy). Outside the field, or where an obstacle is in the way, the move
   * is undone, arithmetically as in CamSim so that the last bits of the position may differ, and
   * the target turns by pi + (2u - 1) pi/6.
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
