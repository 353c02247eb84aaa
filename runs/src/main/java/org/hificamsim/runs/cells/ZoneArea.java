package org.hificamsim.runs.cells;

import java.util.Arrays;
import java.util.function.Function;
import java.util.stream.IntStream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.core.visibility.Body;

/**
 * Measures the area of a zone, and the share of it that cameras see as the zone demands. All
 * commands measure zones in this way.
 *
 * <p>The raster has about {@value #CELLS} cells whatever the size of the zone, since the error is
 * up to half a cell along each edge. In zones up to 100 square metres, 0.1 m is a multiple of the
 * cells' width, so that obstacles whose edges are at tenths of metres coincide with edges of cells
 * if the zone begins at tenths. Cells whose centre is in an obstacle do not count; a cell that
 * fewer than k cameras see counts in part.
 */
public final class ZoneArea {
  private static final int CELLS = 10_000;
  private static final double TENTH = 0.1;
  private static final double MIN_EDGE = 0.001;
  private static final double ROUNDING = 1e-9;

  private final Zone zone;
  private final int[] freeCells;
  private final ViewCells views;
  private final double[] camerasByCell;

  /** The cells that each camera saw when the share was computed last. */
  private ViewCells.Seen[] measured = {};

  private double share;

  /**
   * @param zone the zone, with the number of cameras that it demands
   * @param detection the detection by which cameras have to see the zone
   */
  public ZoneArea(Scenario site, Zone zone, Detection detection) {
    this.zone = zone;
    FieldCells raster = raster(zone.bounds(site.field()));
    Obstacles obstacles = new Obstacles(site.obstacles());
    freeCells =
        IntStream.range(0, raster.count())
            .filter(cell -> zone.contains(raster.x(cell), raster.y(cell)))
            .filter(cell -> obstacles.containing(raster.x(cell), raster.y(cell)).isEmpty())
            .toArray();
    Body body = UsualTarget.body(site, zone, detection);
    double head = UsualTarget.of(site).height();
    views =
        new ViewCells(
            raster,
            detection,
            obstacles,
            network -> body,
            (east, north, z) -> zone.showsFace(east, north, z - head));
    camerasByCell = new double[raster.count()];
  }

  /**
   * Returns the area of a zone, which may omit its detection and its number of cameras.
   *
   * @param usual the detection of zones that name none
   * @param detections finds a detection by the name that a zone has
   */
  public static ZoneArea of(
      Scenario site, Zone zone, Detection usual, Function<String, Detection> detections) {
    Zone demanded = zone.withDefaults(usual.name(), site.objective());
    String name = demanded.detection();
    Detection detection = name.equals(usual.name()) ? usual : detections.apply(name);
    return new ZoneArea(site, demanded, detection);
  }

  private static FieldCells raster(Field bounds) {
    double exact = Math.max(MIN_EDGE, Math.sqrt(bounds.width() * bounds.height() / CELLS));
    double edge = exact < TENTH ? TENTH / Math.ceil(TENTH / exact - ROUNDING) : exact;
    return new FieldCells(bounds, count(bounds.width(), edge), count(bounds.height(), edge));
  }

  private static int count(double side, double edge) {
    return Math.max(1, (int) Math.ceil(side / edge - ROUNDING));
  }

  /** Whether the zone has no free cell. */
  boolean isEmpty() {
    return freeCells.length == 0;
  }

  /** The area of the zone outside obstacles, in square metres. */
  public double squareMetres() {
    return freeCells.length * views.cells().width() * views.cells().height();
  }

  /** The weight of the zone: its attribute times its free area in square metres. */
  public double weight() {
    return zone.weight() * squareMetres();
  }

  /** The raster on which the zone is measured. */
  public FieldCells cells() {
    return views.cells();
  }

  /** Forgets what cameras see, because they may have been moved. */
  void forget(NetworkView network) {
    views.forget(network);
  }

  /** The share that is seen as demanded by the views in which the cameras are now, in [0, 1]. */
  public double met(NetworkView network) {
    return share(views.now(network));
  }

  /** The share that is seen as demanded if each camera sees what any of its views sees. */
  public double metByAnyView(NetworkView network) {
    return share(views.inAnyView(network));
  }

  /**
   * Returns for each cell of the raster the share that the last measurement found missing, in [0,
   * 1]; 0 if the zone demands nothing.
   */
  public double[] missing() {
    double[] missing = new double[cells().count()];
    for (int cell : freeCells) {
      missing[cell] = 1 - met(cell);
    }
    return missing;
  }

  private double met(int cell) {
    return Math.min(1, camerasByCell[cell] / zone.k());
  }

  private double share(ViewCells.Seen[] seenByCamera) {
    if (seenByCamera != measured) {
      measured = seenByCamera;
      share = computeShare();
    }
    return share;
  }

  private double computeShare() {
    Arrays.fill(camerasByCell, 0);
    for (ViewCells.Seen seen : measured) {
      for (int i = 0; i < seen.cells().length; i++) {
        camerasByCell[seen.cells()[i]] += seen.chances()[i];
      }
    }
    double met = 0;
    for (int cell : freeCells) {
      met += met(cell);
    }
    return met / freeCells.length;
  }
}
