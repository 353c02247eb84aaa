package org.hificamsim.core.engine;

import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.space.PointGrid;
import org.hificamsim.core.visibility.Body;
import org.hificamsim.core.visibility.LevelSight;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.visibility.Visibility;
import org.hificamsim.core.world.Cameras;
import org.hificamsim.core.world.SightLines;
import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;

/**
 * Finds what cameras can see at the present positions of everything: {@link Visibility} for many
 * targets at a time.
 *
 * <p>Where there are many targets, a camera looks only at those in the grid cells that its reach
 * touches. The distance test is unpredictable, so the sign bit of a difference of squared distances
 * is read instead of branching. A camera that detects every target within reach ({@link
 * LevelTable#detectsAllInReach}) needs no other test.
 */
final class Sight {
  /** The number of pairs of cameras and targets below which a grid saves no time. */
  private static final long MIN_PAIRS = 4_000;

  /** The least number of cells that saves time: with fewer, most cameras look at most targets. */
  private static final int MIN_CELLS = 40;

  private final Cameras cameras;
  private final Targets targets;
  private final Visibility visibility;
  private final Field field;
  private final SightLines lines;
  private final Obstruction obstruction;
  private final TargetBodies bodies;
  private final LevelTable levels;
  private final PointGrid grid;
  private final DetectionMasks masksByView;

  private long step;

  Sight(World world, Visibility visibility) {
    this(world, visibility, Double.NaN);
  }

  /**
   * @param side the side of the grid's cells, in metres; NaN to choose one
   */
  Sight(World world, Visibility visibility, double side) {
    this.cameras = world.cameras();
    this.targets = world.targets();
    this.lines = world.sightLines();
    this.visibility = visibility;
    this.field = world.scenario().field();
    DetectionModel model = visibility.detection().model();
    this.obstruction = new Obstruction(world, model);
    lines.applyRuleOf(model);
    this.bodies = new TargetBodies(targets, lines.flat());
    this.levels = new LevelTable(cameras, visibility, bodies, obstruction.open());
    this.grid = Double.isNaN(side) ? chosenGrid() : over(side);
    this.masksByView = new DetectionMasks(this, world, levels, grid);
  }

  private PointGrid chosenGrid() {
    if ((long) cameras.count() * targets.count() < MIN_PAIRS) {
      return PointGrid.single(targets.count());
    }
    PointGrid cells = over(levels.meanReach());
    return cells.cells() < MIN_CELLS ? PointGrid.single(targets.count()) : cells;
  }

  private PointGrid over(double side) {
    return PointGrid.over(
        field.minX(), field.minY(), field.width(), field.height(), side, targets.count());
  }

  /** Begins a step: finds the zoom levels of cameras that changed since the last one. */
  void beginStep(long newStep) {
    step = newStep;
    levels.update();
  }

  /** Reads the positions of the targets. No camera detects a target whose position is NaN. */
  void locate() {
    grid.clear();
    obstruction.begin();
    for (int target = 0; target < targets.count(); target++) {
      double x = targets.x(target);
      double y = targets.y(target);
      if (targets.present(target) && !Double.isNaN(x) && !Double.isNaN(y)) {
        grid.add(target, x, y);
      }
    }
    grid.sort();
  }

  long step() {
    return step;
  }

  /** The obstacles, as far as the installer of the cameras knows them. */
  Obstacles map() {
    return lines.map();
  }

  /** The mean width of targets if they hide each other; else 0. */
  double hidingWidth() {
    return lines.hidingWidth();
  }

  boolean hasPhantoms() {
    return visibility.detection().rule().phantoms() > 0;
  }

  /** The number of phantoms that a camera reports in this step; 0 while it sees nothing. */
  int phantoms(int camera) {
    boolean looks = cameras.online(camera) && cameras.seeing(camera) != Cameras.NO_VIEW;
    return looks ? visibility.phantoms(step, camera) : 0;
  }

  /** The positions of the targets at the last call of {@link #locate}. */
  PointGrid grid() {
    return grid;
  }

  LevelSight level(int camera, int view, int target) {
    return levels.level(cameras.zoomNumber(camera, view), bodies.indexOf(target));
  }

  double luck(int camera, int target) {
    return visibility.luck(step, camera, target);
  }

  /** The obstacles and targets that hide targets. */
  Obstruction obstruction() {
    return obstruction;
  }

  boolean certain() {
    return visibility.detection().certain();
  }

  /** Whether the camera detects the target through the view that it sees through. */
  boolean sees(int camera, int target) {
    int view = cameras.seeing(camera);
    return cameras.online(camera) && view != Cameras.NO_VIEW && detects(camera, view, target);
  }

  boolean detects(int camera, int view, int target) {
    return targets.present(target) && detects(camera, view, target, cameras.pose(camera, view));
  }

  private boolean detects(int camera, int view, int target, Pose pose) {
    LevelSight level = level(camera, view, target);
    double x = targets.x(target);
    double y = targets.y(target);
    double squared = pose.squaredDistance(x, y);
    return level.isInReach(squared)
        && level.isInAngle(pose, x, y)
        && level.detectsInView(
            pose,
            x,
            y,
            squared,
            luck(camera, target),
            obstruction.transmittance(camera, target),
            obstruction.hiddenShare(camera, target));
  }

  double chance(int camera, int view, int target) {
    return targets.present(target)
        ? level(camera, view, target)
            .chance(
                cameras.pose(camera, view),
                targets.x(target),
                targets.y(target),
                obstruction.transmittance(camera, target),
                obstruction.hiddenShare(camera, target))
        : 0;
  }

  boolean chancesAt(
      int camera, double x, double y, double size, double transmittance, double[] chances) {
    double squared = cameras.pose(camera).squaredDistance(x, y);
    int nearest = bodies.nearest(size);
    boolean any = false;
    for (int view = 0; view < cameras.views(camera) && nearest >= 0; view++) {
      int number = cameras.zoomNumber(camera, view);
      chances[view] = 0;
      if (squared < levels.squaredLimit(number) && transmittance > 0) {
        LevelSight level = levels.level(number, nearest);
        chances[view] = level.chance(cameras.pose(camera, view), x, y, transmittance);
        any |= chances[view] > 0;
      }
    }
    return any;
  }

  Body body(double size) {
    int nearest = bodies.nearest(size);
    return nearest < 0 ? Body.flat(size) : bodies.body(nearest);
  }

  double confidence(int camera, int target) {
    int view = cameras.seeing(camera);
    if (!targets.present(target) || view == Cameras.NO_VIEW) {
      return 0;
    }
    double value =
        level(camera, view, target)
            .valueWhenHidden(
                cameras.pose(camera, view),
                targets.x(target),
                targets.y(target),
                obstruction.hiddenShare(camera, target));
    return DetectionModel.clamp(value * obstruction.transmittance(camera, target));
  }

  /**
   * Returns the confidence in a seen target. Only partly transparent obstacles matter, because a
   * seen target is not hidden.
   */
  double seenConfidence(int camera, int target, double distance) {
    if (obstruction.byShares()) {
      return confidence(camera, target);
    }
    int view = cameras.seeing(camera);
    double value =
        level(camera, view, target)
            .value(cameras.pose(camera, view), targets.x(target), targets.y(target), distance);
    double through = lines.partial() ? lines.transmittance(camera, target) : 1;
    return DetectionModel.clamp(value * through);
  }

  boolean dominates(int camera, int view, int other) {
    if (view == other || lines.partial()) {
      return view == other;
    }
    for (int body = 0; body < bodies.count(); body++) {
      LevelSight dominating = levels.level(cameras.zoomNumber(camera, view), body);
      LevelSight dominated = levels.level(cameras.zoomNumber(camera, other), body);
      if (!dominating.byDistance() || !dominating.includes(dominated)) {
        return false;
      }
    }
    return cameras.zoom(camera, view).allRound()
        || cameras.pan(camera, view) == cameras.pan(camera, other);
  }

  /** The distance beyond which a camera detects nothing in a view, in metres; rounded up. */
  double reach(int camera, int view) {
    return levels.reach(cameras.zoomNumber(camera, view));
  }

  /**
   * Lets every online camera look at the targets through the view that it sees through.
   *
   * @param detected receives the number of targets that each camera detects
   * @param counts one entry for each target in the order of the grid; each camera that detects the
   *     target adds one
   * @param found scratch memory: an entry for each target, and one more
   */
  void look(int[] detected, int[] counts, long[] found) {
    for (int camera = 0; camera < detected.length; camera++) {
      detected[camera] = look(camera, counts, found);
    }
  }

  /** Lets one camera look; returns the number of targets that it detects. */
  int look(int camera, int[] counts, long[] found) {
    int view = cameras.online(camera) ? cameras.seeing(camera) : Cameras.NO_VIEW;
    if (view == Cameras.NO_VIEW) {
      return 0;
    }
    int zoom = cameras.zoomNumber(camera, view);
    if (grid.cells() == 1 && levels.detectsAllInReach(zoom)) {
      return count(camera, levels.squaredLimit(zoom), counts);
    }
    int seen = find(camera, view, found);
    for (int k = 0; k < seen; k++) {
      counts[(int) found[k]]++;
    }
    return seen;
  }

  private int count(int camera, double below, int[] counts) {
    double x = cameras.x(camera);
    double y = cameras.y(camera);
    int seen = 0;
    for (int i = 0; i < grid.count(); i++) {
      double dx = grid.x(i) - x;
      double dy = grid.y(i) - y;
      int hit = negative(dx * dx + dy * dy - below);
      counts[i] += hit;
      seen += hit;
    }
    return seen;
  }

  /** Returns 1 for a negative number, else 0. */
  static int negative(double difference) {
    return (int) (Double.doubleToRawLongBits(difference) >>> 63);
  }

  /**
   * Finds the targets that the camera detects at a view.
   *
   * @param view {@link Cameras#NO_VIEW} sees none
   * @param found receives their indices in the grid
   * @return the number of indices; one more entry may be written
   */
  int find(int camera, int view, long[] found) {
    if (view == Cameras.NO_VIEW) {
      return 0;
    }
    if (grid.cells() == 1) {
      return find(camera, view, 0, grid.count(), found, 0);
    }
    double reach = reach(camera, view);
    int left = grid.column(cameras.x(camera) - reach);
    int right = grid.column(cameras.x(camera) + reach);
    int top = grid.row(cameras.y(camera) + reach);
    int filled = 0;
    for (int row = grid.row(cameras.y(camera) - reach); row <= top; row++) {
      filled = find(camera, view, grid.start(row, left), grid.end(row, right), found, filled);
    }
    return filled;
  }

  private int find(int camera, int view, int from, int to, long[] found, int first) {
    int number = cameras.zoomNumber(camera, view);
    double below = levels.squaredLimit(number);
    int filled = grid.findNear(cameras.x(camera), cameras.y(camera), below, from, to, found, first);
    return levels.detectsAllInReach(number)
        ? filled
        : keepDetected(camera, view, found, first, filled);
  }

  /** Keeps those targets in reach that are detected. */
  private int keepDetected(int camera, int view, long[] found, int first, int end) {
    int kept = first;
    for (int k = first; k < end; k++) {
      if (detects(camera, view, grid.point((int) found[k]), cameras.pose(camera, view))) {
        found[kept++] = found[k];
      }
    }
    return kept;
  }

  void findSeen(SeenPairs pairs) {
    pairs.clear();
    for (int camera = 0; camera < cameras.count(); camera++) {
      if (cameras.online(camera)) {
        long[] found = pairs.scratch(targets.count() + 1);
        int view = cameras.seeing(camera);
        int count = find(camera, view, found);
        for (int k = 0; k < count; k++) {
          int i = (int) found[k];
          addPair(camera, grid.point(i), grid.x(i), grid.y(i), pairs);
        }
      }
    }
  }

  /** Adds a target at a position, relative to the axis of the view that the camera has. */
  void addPair(int camera, int target, double x, double y, SeenPairs pairs) {
    Pose pose = cameras.pose(camera, cameras.seeing(camera));
    double dx = x - pose.x();
    double dy = y - pose.y();
    double ahead = dx * pose.headingX() + dy * pose.headingY();
    double right = dx * pose.headingY() - dy * pose.headingX();
    pairs.add(camera, target, ahead, right);
  }

  int chances(int camera, int view, int[] possible, double[] chances) {
    double reach = reach(camera, view);
    int left = grid.column(cameras.x(camera) - reach);
    int right = grid.column(cameras.x(camera) + reach);
    int top = grid.row(cameras.y(camera) + reach);
    int count = 0;
    for (int row = grid.row(cameras.y(camera) - reach); row <= top; row++) {
      int end = grid.end(row, right);
      for (int i = grid.start(row, left); i < end; i++) {
        chances[count] = chance(camera, view, grid.point(i));
        possible[count] = grid.point(i);
        count += chances[count] > 0 ? 1 : 0;
      }
    }
    return count;
  }

  void detections(int camera, long[] masks, int words) {
    masksByView.fill(camera, masks, words);
  }
}
