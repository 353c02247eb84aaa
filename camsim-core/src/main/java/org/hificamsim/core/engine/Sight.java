package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.scenario.Scenario;
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
 * What cameras can see, where everything is now: {@link Visibility}, asked of many targets at a
 * time. Between two calls of {@link #beginStep} or {@link #locate} any number of threads may ask.
 *
 * <p>What a camera sees at a zoom level is found when the level is first met, once for each size of
 * targets, and where cameras have heights, for what of them has to be seen. Where targets are many,
 * a camera looks at those in the cells of a grid that its reach touches.
 *
 * <p>Whether a target is near enough is a coin toss that a processor's guess of a branch loses half
 * of the time. So the sign bit of a difference of squared distances says it, and a camera that
 * detects all that is near enough ({@link #whole}) needs no branch.
 */
abstract class Sight implements OracleView {
  /** Pairs of cameras and targets below which looking at all takes no longer. */
  private static final long MIN_PAIRS = 4_000;

  /** With fewer cells most cameras would look at most targets anyway. */
  private static final int MIN_CELLS = 40;

  private static final double NOT_KNOWN = -1;

  final Cameras cameras;
  final Targets targets;
  final Visibility visibility;
  final Scenario scenario;
  private final SightLines lines;
  private final boolean open;
  private final Body[] bodies; // the smallest first
  private final int[] kind; // of each target: its body's number
  private final PointGrid grid;
  private LevelSight[] levels = {}; // by the zoom level's number, then by body
  private double[] outside = {}; // by number: from this squared distance on nothing is detected
  private double[] reach = {}; // by number: beyond this distance, metres, nothing is detected
  private boolean[] whole = {}; // by number: whatever is nearer is detected
  private boolean allWhole = true; // all levels are whole
  private int revision = -1;
  private long step;

  /**
   * @param side of the grid's cells, metres; NaN where it is to be chosen
   */
  Sight(World world, Visibility visibility, double side) {
    this.cameras = world.cameras();
    this.targets = world.targets();
    this.lines = world.sightLines();
    this.open = lines.open();
    this.visibility = visibility;
    this.scenario = world.scenario();
    lines.require(visibility.detection().model().seen());
    Body[] all = new Body[targets.count()];
    Arrays.setAll(all, lines.flat() ? target -> Body.flat(targets.size(target)) : targets::body);
    this.bodies = Arrays.stream(all).sorted(Body.ORDER).distinct().toArray(Body[]::new);
    this.kind = new int[all.length];
    Arrays.setAll(kind, target -> Arrays.binarySearch(bodies, all[target], Body.ORDER));
    findLevels();
    this.grid = Double.isNaN(side) ? chosenGrid() : over(side);
  }

  private PointGrid chosenGrid() {
    if ((long) cameras.count() * targets.count() < MIN_PAIRS) {
      return PointGrid.single(targets.count());
    }
    PointGrid cells = over(meanReach());
    return cells.cells() < MIN_CELLS ? PointGrid.single(targets.count()) : cells;
  }

  private PointGrid over(double side) {
    Field field = field();
    return PointGrid.over(
        field.minX(), field.minY(), field.width(), field.height(), side, kind.length);
  }

  /** How far a camera sees, metres. */
  private double meanReach() {
    double sum = 0;
    for (int camera = 0; camera < cameras.count(); camera++) {
      int last = cameras.views(camera) - 1;
      ZoomLevel widest = cameras.zoom(camera, last);
      sum +=
          widest.hasLens()
              ? Math.sqrt(reach(camera, 0) * reach(camera, last)) // of the narrowest and the widest
              : widest.radius();
    }
    return sum / cameras.count();
  }

  /** Takes note of the step that begins, and of cameras that changed since the last one. */
  void beginStep(long newStep) {
    step = newStep;
    if (revision != cameras.revision()) {
      findLevels();
    }
  }

  private void findLevels() {
    revision = cameras.revision();
    for (int camera = 0; camera < cameras.count(); camera++) {
      for (int view = 0; view < cameras.views(camera); view++) {
        int number = cameras.zoomNumber(camera, view);
        if (number >= outside.length || outside[number] == 0) {
          findLevel(number, camera, view);
        }
      }
    }
  }

  private void findLevel(int number, int camera, int view) {
    if (number >= outside.length) {
      int length = Math.max(number + 1, 2 * outside.length);
      levels = Arrays.copyOf(levels, length * bodies.length);
      outside = Arrays.copyOf(outside, length);
      reach = Arrays.copyOf(reach, length);
      whole = Arrays.copyOf(whole, length);
    }
    double farthest = -1;
    for (int body = 0; body < bodies.length; body++) {
      LevelSight level = visibility.at(cameras.zoom(camera, view), bodies[body]);
      levels[number * bodies.length + body] = level;
      farthest = Math.max(farthest, level.farthest());
      reach[number] = Math.max(reach[number], level.reach());
      whole[number] = bodies.length == 1 && level.isDisc() && level.byDistance() && open;
    }
    outside[number] = Math.nextUp(farthest);
    allWhole &= whole[number];
  }

  /**
   * Takes note of where the targets are. One whose place is no number is nowhere: no camera detects
   * it.
   */
  void locate() {
    grid.clear();
    for (int target = 0; target < kind.length; target++) {
      double x = targets.x(target);
      double y = targets.y(target);
      if (targets.present(target) && !Double.isNaN(x) && !Double.isNaN(y)) {
        grid.add(target, x, y);
      }
    }
    grid.sort();
  }

  @Override
  public long step() {
    return step;
  }

  @Override
  public Field field() {
    return scenario.field();
  }

  @Override
  public Obstacles obstacles() {
    return lines.map();
  }

  /** Where the targets were when they were last located. */
  PointGrid grid() {
    return grid;
  }

  private LevelSight level(int camera, int view, int target) {
    return levels[cameras.zoomNumber(camera, view) * bodies.length + kind[target]];
  }

  private double transmittance(int camera, int target) {
    return open ? 1 : lines.transmittance(camera, target);
  }

  @Override
  public boolean certain() {
    return visibility.detection().certain();
  }

  @Override
  public boolean detects(int camera, int view, int target) {
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
            visibility.luck(step, camera, target),
            transmittance(camera, target));
  }

  @Override
  public double chance(int camera, int view, int target) {
    return targets.present(target)
        ? level(camera, view, target)
            .chance(
                cameras.pose(camera, view),
                targets.x(target),
                targets.y(target),
                transmittance(camera, target))
        : 0;
  }

  @Override
  public boolean chancesAt(
      int camera, double x, double y, double size, double transmittance, double[] chances) {
    double squared = cameras.pose(camera).squaredDistance(x, y);
    int nearest = nearestSize(size);
    boolean any = false;
    for (int view = 0; view < cameras.views(camera) && nearest >= 0; view++) {
      int number = cameras.zoomNumber(camera, view);
      chances[view] = 0;
      if (squared < outside[number] && transmittance > 0) {
        LevelSight level = levels[number * bodies.length + nearest];
        chances[view] = level.chance(cameras.pose(camera, view), x, y, transmittance);
        any |= chances[view] > 0;
      }
    }
    return any;
  }

  private int nearestSize(double size) {
    int nearest = bodies.length - 1;
    while (nearest > 0 && size - bodies[nearest - 1].size() <= bodies[nearest].size() - size) {
      nearest--;
    }
    return nearest;
  }

  @Override
  public Body body(double size) {
    int nearest = nearestSize(size);
    return nearest < 0 ? Body.flat(size) : bodies[nearest];
  }

  @Override
  public double confidence(int camera, int target) {
    int view = cameras.seeing(camera);
    if (!targets.present(target) || view == Cameras.NO_VIEW) {
      return 0;
    }
    double value =
        level(camera, view, target)
            .value(cameras.pose(camera, view), targets.x(target), targets.y(target));
    return DetectionModel.clamp(value * lines.transmittance(camera, target));
  }

  /** What is seen is not hidden: only what lets a part of the light through is asked. */
  @Override
  public double seenConfidence(int camera, int target, double distance) {
    int view = cameras.seeing(camera);
    double value =
        level(camera, view, target)
            .value(cameras.pose(camera, view), targets.x(target), targets.y(target), distance);
    double through = lines.partial() ? lines.transmittance(camera, target) : 1;
    return DetectionModel.clamp(value * through);
  }

  @Override
  public boolean dominates(int camera, int view, int other) {
    if (view == other || lines.partial()) {
      return view == other;
    }
    for (int body = 0; body < bodies.length; body++) {
      LevelSight mine = levels[cameras.zoomNumber(camera, view) * bodies.length + body];
      LevelSight its = levels[cameras.zoomNumber(camera, other) * bodies.length + body];
      if (!mine.byDistance() || !mine.includes(its)) {
        return false;
      }
    }
    return cameras.zoom(camera, view).allRound()
        || cameras.pan(camera, view) == cameras.pan(camera, other);
  }

  /** Rounded up. */
  @Override
  public double reach(int camera, int view) {
    return reach[cameras.zoomNumber(camera, view)];
  }

  /**
   * Looks with some cameras, each through the view that it sees through.
   *
   * @param detected receives how many targets each of the cameras detects
   * @param counts by index in the grid; one is added for each camera that detects the target
   * @param room for what a camera detects: an entry for each target, and one more
   */
  void look(int first, int end, int[] detected, int[] counts, long[] room) {
    for (int camera = first; camera < end; camera++) {
      int view = cameras.online(camera) ? cameras.seeing(camera) : Cameras.NO_VIEW;
      if (view == Cameras.NO_VIEW) {
        detected[camera] = 0;
      } else if (grid.cells() == 1 && whole[cameras.zoomNumber(camera, view)]) {
        detected[camera] = count(camera, outside[cameras.zoomNumber(camera, view)], counts);
      } else {
        detected[camera] = find(camera, view, room);
        for (int k = 0; k < detected[camera]; k++) {
          counts[(int) room[k]]++;
        }
      }
    }
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

  /** 1 or 0, by the sign bit. */
  private static int negative(double difference) {
    return (int) (Double.doubleToRawLongBits(difference) >>> 63);
  }

  /**
   * Finds the targets that the camera detects at a view.
   *
   * @param view {@link Cameras#NO_VIEW} sees none
   * @param found receives their indices in the grid
   * @return how many there are; the next entry may be written, too
   */
  private int find(int camera, int view, long[] found) {
    if (view == Cameras.NO_VIEW) {
      return 0;
    }
    if (grid.cells() == 1) {
      return find(camera, view, 0, grid.count(), found, 0);
    }
    double far = reach(camera, view);
    int left = grid.column(cameras.x(camera) - far);
    int right = grid.column(cameras.x(camera) + far);
    int top = grid.row(cameras.y(camera) + far);
    int filled = 0;
    for (int row = grid.row(cameras.y(camera) - far); row <= top; row++) {
      filled = find(camera, view, grid.start(row, left), grid.end(row, right), found, filled);
    }
    return filled;
  }

  private int find(int camera, int view, int from, int to, long[] found, int first) {
    int number = cameras.zoomNumber(camera, view);
    double below = outside[number];
    double x = cameras.x(camera);
    double y = cameras.y(camera);
    int filled = first;
    for (int i = from; i < to; i++) {
      double dx = grid.x(i) - x;
      double dy = grid.y(i) - y;
      found[filled] = i;
      filled += negative(dx * dx + dy * dy - below);
    }
    return whole[number] ? filled : keepDetected(camera, view, found, first, filled);
  }

  /** Leaves out what is near enough, but not detected. */
  private int keepDetected(int camera, int view, long[] found, int first, int end) {
    int kept = first;
    for (int k = first; k < end; k++) {
      if (detects(camera, view, grid.point((int) found[k]), cameras.pose(camera, view))) {
        found[kept++] = found[k];
      }
    }
    return kept;
  }

  @Override
  public void findSeen(SeenPairs pairs) {
    pairs.clear();
    for (int camera = 0; camera < cameras.count(); camera++) {
      if (cameras.online(camera)) {
        long[] room = pairs.scratch(kind.length + 1);
        int view = cameras.seeing(camera);
        addSeen(camera, view, room, find(camera, view, room), pairs);
      }
    }
  }

  /** Adds what was found, with the places of the targets in the camera's picture. */
  private void addSeen(int camera, int view, long[] found, int count, SeenPairs pairs) {
    for (int k = 0; k < count; k++) {
      int i = (int) found[k];
      Pose pose = cameras.pose(camera, view);
      double dx = grid.x(i) - pose.x();
      double dy = grid.y(i) - pose.y();
      double ahead = dx * pose.headingX() + dy * pose.headingY();
      double right = dx * pose.headingY() - dy * pose.headingX();
      pairs.add(camera, grid.point(i), ahead, right);
    }
  }

  @Override
  public int chances(int camera, int view, int[] who, double[] chances) {
    double far = reach(camera, view);
    int left = grid.column(cameras.x(camera) - far);
    int right = grid.column(cameras.x(camera) + far);
    int top = grid.row(cameras.y(camera) + far);
    int count = 0;
    for (int row = grid.row(cameras.y(camera) - far); row <= top; row++) {
      int end = grid.end(row, right);
      for (int i = grid.start(row, left); i < end; i++) {
        chances[count] = chance(camera, view, grid.point(i));
        who[count] = grid.point(i);
        count += chances[count] > 0 ? 1 : 0;
      }
    }
    return count;
  }

  @Override
  public void detections(int camera, long[] masks, int words) {
    int views = cameras.views(camera);
    Arrays.fill(masks, 0, views * words, 0);
    if (grid.cells() == 1) {
      mark(camera, views, 0, grid.count(), masks, words);
      return;
    }
    double far = 0;
    for (int view = 0; view < views; view++) {
      far = Math.max(far, reach(camera, view));
    }
    int left = grid.column(cameras.x(camera) - far);
    int right = grid.column(cameras.x(camera) + far);
    int top = grid.row(cameras.y(camera) + far);
    for (int row = grid.row(cameras.y(camera) - far); row <= top; row++) {
      mark(camera, views, grid.start(row, left), grid.end(row, right), masks, words);
    }
  }

  private void mark(int camera, int views, int from, int to, long[] masks, int words) {
    double below = farthestOutside(camera, views);
    for (int i = from; i < to; i++) {
      double dx = grid.x(i) - cameras.x(camera);
      double dy = grid.y(i) - cameras.y(camera);
      double squared = dx * dx + dy * dy;
      if (allWhole) {
        markNear(camera, views, grid.point(i), squared, masks, words);
      } else if (squared < below) {
        markDetected(camera, views, grid.point(i), squared, masks, words);
      }
    }
  }

  private double farthestOutside(int camera, int views) {
    double farthest = 0;
    for (int view = 0; view < views && !allWhole; view++) {
      farthest = Math.max(farthest, outside[cameras.zoomNumber(camera, view)]);
    }
    return farthest;
  }

  private void markNear(
      int camera, int views, int target, double squared, long[] masks, int words) {
    for (int view = 0; view < views; view++) {
      long hit = negative(squared - outside[cameras.zoomNumber(camera, view)]);
      masks[view * words + (target >> 6)] |= hit << target;
    }
  }

  /** What is in between is found once for all views, when a first one has the target in view. */
  private void markDetected(
      int camera, int views, int target, double squared, long[] masks, int words) {
    double luck = visibility.luck(step, camera, target);
    double x = targets.x(target);
    double y = targets.y(target);
    double transmittance = NOT_KNOWN;
    for (int view = 0; view < views; view++) {
      LevelSight level = level(camera, view, target);
      Pose pose = cameras.pose(camera, view);
      if (level.isInReach(squared) && level.isInAngle(pose, x, y)) {
        transmittance = transmittance < 0 ? transmittance(camera, target) : transmittance;
        long hit = level.detectsInView(pose, x, y, squared, luck, transmittance) ? 1 : 0;
        masks[view * words + (target >> 6)] |= hit << target;
      }
    }
  }
}
