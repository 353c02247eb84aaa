package org.hificamsim.runs.cells;

import java.util.Arrays;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.VisibleRegion;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.visibility.Body;
import org.hificamsim.core.visibility.LevelSight;
import org.hificamsim.core.visibility.Pose;
import org.hificamsim.core.visibility.Visibility;

/**
 * Computes the cells that each camera sees in each of its views. They are computed when a view is
 * first used, and kept until a camera is moved or they take too much memory.
 */
public final class ViewCells {
  /**
   * The cells of a view in which the camera would detect a target at the centre.
   *
   * @param cells the numbers of the cells, in ascending order
   * @param chances the chances of a detection in each of these cells, above 0
   */
  public record Seen(int[] cells, double[] chances) {
    private static final Seen NOTHING = new Seen(new int[0], new double[0]);
  }

  /** A condition on the position of a camera, without which a target in a cell does not count. */
  @FunctionalInterface
  public interface Condition {
    /** The condition that always holds. */
    Condition NONE = (east, north, z) -> true;

    /**
     * Whether a target counts.
     *
     * @param east metres to the east, from the target to the camera
     * @param north metres to the north, from the target to the camera
     * @param z the camera's height, in metres; NaN in a flat world
     */
    boolean holds(double east, double north, double z);
  }

  /** The most cells that are kept for all views together: 50 MB. */
  private static final int MAX_KEPT = 1 << 22;

  private final FieldCells cells;
  private final Visibility visibility;
  private final Obstacles obstacles;
  private final Function<NetworkView, Body> bodies;
  private final Condition condition;
  private int revision;
  private VisibleRegion[] regions = {};
  private Seen[][] seen = {};
  private double[][] pans = {};
  private long keptCells;
  private Seen[] next = {};
  private Seen[] now = {};

  /**
   * @param bodies the part of a target that must be seen, by network
   */
  public ViewCells(
      FieldCells cells,
      Detection detection,
      Obstacles obstacles,
      Function<NetworkView, Body> bodies,
      Condition condition) {
    this.cells = cells;
    this.visibility = Visibility.of(detection);
    this.obstacles = obstacles;
    this.bodies = bodies;
    this.condition = condition;
  }

  /** The cells of the field. */
  FieldCells cells() {
    return cells;
  }

  /** Forgets all cells, because the cameras may have been moved. */
  public void forget(NetworkView network) {
    revision = network.revision();
    regions = new VisibleRegion[network.cameras()];
    seen = new Seen[network.cameras()][];
    pans = new double[network.cameras()][];
    keptCells = 0;
  }

  /** The cells that each camera sees now; returns the same array until a camera sees others. */
  public Seen[] now(NetworkView network) {
    if (revision != network.revision() || seen.length != network.cameras()) {
      forget(network);
    }
    if (next.length != network.cameras()) {
      next = new Seen[network.cameras()];
    }
    for (int camera = 0; camera < next.length; camera++) {
      next[camera] = network.online(camera) ? now(network, camera) : Seen.NOTHING;
    }
    if (!Arrays.equals(next, now)) {
      now = next.clone();
    }
    return now;
  }

  /** The cells that each camera sees in any of its views, each with its greatest chance. */
  Seen[] inAnyView(NetworkView network) {
    forget(network);
    Seen[] union = new Seen[network.cameras()];
    for (int camera = 0; camera < union.length; camera++) {
      union[camera] = network.online(camera) ? inAnyView(network, camera) : Seen.NOTHING;
    }
    return union;
  }

  private Seen inAnyView(NetworkView network, int camera) {
    double[] chances = new double[cells.count()];
    for (int view = 0; view < network.views(camera); view++) {
      Seen inView = seenIn(network, camera, view, network.pan(camera, view));
      for (int i = 0; i < inView.cells.length; i++) {
        chances[inView.cells[i]] = Math.max(chances[inView.cells[i]], inView.chances[i]);
      }
    }
    int[] numbers = IntStream.range(0, chances.length).filter(cell -> chances[cell] > 0).toArray();
    return new Seen(numbers, IntStream.of(numbers).mapToDouble(cell -> chances[cell]).toArray());
  }

  private Seen now(NetworkView network, int camera) {
    int view = network.seeing(camera);
    if (view < 0) {
      return Seen.NOTHING; // the camera is turning
    }
    if (keptCells > MAX_KEPT) {
      forget(network);
    }
    if (seen[camera] == null) {
      seen[camera] = new Seen[network.views(camera)];
      pans[camera] = new double[network.views(camera)];
      Arrays.fill(pans[camera], Double.NaN);
    }
    double pan = network.pan(camera, view);
    if (pans[camera][view] != pan) {
      pans[camera][view] = pan;
      seen[camera][view] = seenIn(network, camera, view, pan);
      keptCells += seen[camera][view].cells().length;
    }
    return seen[camera][view];
  }

  private Seen seenIn(NetworkView network, int camera, int view, double pan) {
    double cameraX = network.cameraX(camera);
    double cameraY = network.cameraY(camera);
    Pose pose = Pose.of(cameraX, cameraY, network.cameraHeading(camera)).turned(pan);
    if (regions[camera] == null && !obstacles.isEmpty()) {
      regions[camera] = VisibleRegion.of(obstacles, cameraX, cameraY);
    }
    VisibleRegion regionOrNull = regions[camera];
    ZoomLevel zoom = network.zoom(camera, view);
    Body body = bodies.apply(network);
    LevelSight sight = visibility.at(zoom, body);
    double reach = sight.reach();
    int left = cells.column(pose.x() - reach);
    int right = cells.column(pose.x() + reach);
    int top = cells.row(pose.y() + reach);
    int[] numbers = new int[cells.count()];
    double[] chances = new double[numbers.length];
    int count = 0;
    for (int row = cells.row(pose.y() - reach); row <= top; row++) {
      for (int column = left; column <= right; column++) {
        int cell = row * cells.columns() + column;
        double x = cells.x(cell);
        double y = cells.y(cell);
        boolean counts = condition.holds(cameraX - x, cameraY - y, zoom.vertical().z());
        double transmittance = counts ? transmittance(regionOrNull, x, y, zoom, body) : 0;
        double chance = transmittance == 0 ? 0 : sight.chance(pose, x, y, transmittance);
        numbers[count] = cell;
        chances[count] = chance;
        count += chance > 0 ? 1 : 0;
      }
    }
    return new Seen(Arrays.copyOf(numbers, count), Arrays.copyOf(chances, count));
  }

  /**
   * The part of a body's light that reaches the camera.
   *
   * @param region the region that the camera sees; null without obstacles
   */
  private static double transmittance(
      VisibleRegion region, double x, double y, ZoomLevel zoom, Body body) {
    return region == null
        ? 1
        : region.transmittance(x, y, zoom.vertical().z(), body.low(), body.high());
  }
}
