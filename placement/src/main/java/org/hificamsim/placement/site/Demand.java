package org.hificamsim.placement.site;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Texts;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.NothingHidden;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.runs.cells.FieldCells;
import org.hificamsim.runs.cells.ZoneArea;

/**
 * The points that cameras have to cover: the centres of the cells of each zone. A cell in two zones
 * counts as two points. (Files and the command line call these points samples.)
 *
 * @param cells for each zone, the cells into which it is cut; empty if only points are needed
 * @param points the points of all zones, in the order of zones
 */
public record Demand(
    Scenario site, List<FieldCells> cells, List<ZoneDemand> zones, List<DemandPoint> points) {
  /**
   * A zone with what it demands.
   *
   * @param k the number of cameras that every point needs
   * @param first the number of the zone's first point
   * @param end the number after that of the zone's last point
   */
  public record ZoneDemand(String name, Detection detection, int k, int first, int end) {
    /** The number of points. */
    public int count() {
      return end - first;
    }
  }

  /**
   * A point that is to be covered; coordinates in metres.
   *
   * @param zone the number of its zone
   * @param weight what covering it is worth, above 0
   */
  public record DemandPoint(double x, double y, int zone, double weight) {}

  /**
   * The detections of a site.
   *
   * @param usual the detection of the scenario
   * @param byName finds the detection that a zone names
   */
  public record Detections(Detection usual, Function<String, Detection> byName) {
    private Detection of(Zone zone) {
      Detection named = zone.detection() == null ? usual : byName.apply(zone.detection());
      Detection detection = withoutCrowd(named);
      if (!detection.certain()) {
        throw InputException.of(
            "zone '%s' is seen by chance, %s, expected a detection by a threshold",
            zone.name(), detection.name());
      }
      return detection;
    }

    /**
     * Returns a detection that does not depend on where people will stand, which nobody knows when
     * a site is planned. A model that depends on what people hide of each other then sees them
     * whole. If no rule was chosen, people are seen from the model's default threshold on.
     */
    private static Detection withoutCrowd(Detection detection) {
      DetectionModel model = detection.model();
      if (!model.dependsOnHiddenShare()) {
        return detection;
      }
      boolean byDefault = detection.rule().equals(model.defaultRule());
      return detection.certain() || byDefault
          ? new Detection(
              byDefault ? model.name() : detection.name(),
              new NothingHidden(model),
              byDefault ? model.defaultThreshold() : detection.threshold())
          : detection;
    }
  }

  /** Returns sentences about what the plan takes for granted. */
  public List<String> assumptions() {
    return zones.stream()
        .map(ZoneDemand::detection)
        .filter(detection -> detection.model() instanceof NothingHidden)
        .map(
            detection ->
                Texts.format(
                    "%s: people are seen from a probability of %s on, and hide nothing of each"
                        + " other, since nobody knows where they will be",
                    detection.model().name(), detection.threshold()))
        .distinct()
        .toList();
  }

  /**
   * Returns the demand of a scenario. The weight of a point is proportional to the area of its
   * cell: it is 1 in a zone of weight 1 with the smallest cells of all zones.
   *
   * @param redundancy the number of cameras that each point needs, in place of what the zones say
   * @param visits for each cell, the number of targets that were in it over time, which is a factor
   *     of the weight, and for which all zones must have the same cells; empty for equal weights
   * @throws InputException if nothing is to be covered
   */
  public static Demand of(
      Scenario site,
      Sampling sampling,
      Optional<Integer> redundancy,
      Detections detections,
      Optional<double[]> visits) {
    Obstacles obstacles = new Obstacles(site.obstacles());
    double leastArea = cellArea(sampling.finest(site));
    int usualK = site.objective() instanceof Objective.Covered covered ? covered.k() : 1;
    List<Zone> zones = Zone.ofSite(site.zones());
    List<FieldCells> cellsOfZones = new ArrayList<>();
    List<ZoneDemand> zoneDemands = new ArrayList<>();
    List<DemandPoint> points = new ArrayList<>();
    for (Zone zone : zones) {
      FieldCells cells = sampling.cells(zone, site.field());
      cellsOfZones.add(cells);
      int first = points.size();
      double zoneWeight = zone.weight() * (cellArea(cells) / leastArea);
      for (int cell = 0; cell < cells.count() && zone.weight() > 0; cell++) {
        double x = cells.x(cell);
        double y = cells.y(cell);
        double weight = zoneWeight * (visits.isPresent() ? visits.get()[cell] : 1);
        if (weight > 0 && zone.contains(x, y) && obstacles.containing(x, y).isEmpty()) {
          points.add(new DemandPoint(x, y, zoneDemands.size(), weight));
        }
      }
      Detection detection = detections.of(zone);
      int k = redundancy.orElse(zone.k() == null ? usualK : zone.k());
      zoneDemands.add(new ZoneDemand(zone.name(), detection, k, first, points.size()));
      if (zone.weight() > 0 && points.size() == first && visits.isEmpty()) {
        throw InputException.of(
            "zone '%s' has no free cell of %s m, expected more %s, or a larger zone",
            zone.name(), cells.width(), setting("cells"));
      }
    }
    if (points.isEmpty()) {
      throw new InputException("nothing is to be seen, expected a zone with a weight above 0");
    }
    return new Demand(site, cellsOfZones, zoneDemands, points);
  }

  private static double cellArea(FieldCells cells) {
    return cells.width() * cells.height();
  }

  /** Returns the cells of a zone. */
  FieldCells cells(ZoneDemand zone) {
    return cells.get(zones.indexOf(zone));
  }

  /** Returns the cells of the zone that has the smallest ones. */
  public FieldCells finestCells() {
    return Collections.min(cells, Comparator.comparingDouble(FieldCells::width));
  }

  /** The width of the largest cells, in metres. */
  public double greatestCellWidth() {
    return cells.stream().mapToDouble(FieldCells::width).max().orElseThrow();
  }

  /**
   * Returns, for each cell of a grid, the number of the zone's point in whose cell the centre of
   * the grid's cell is; -1 if the zone asks for nothing there. Beside an obstacle, the point of the
   * zone's cell may be missing since it would be in the obstacle: the nearest point then takes its
   * place.
   *
   * @param grid the cells of the zone, or others of the same field
   */
  public int[] pointsByCell(ZoneDemand zone, FieldCells grid) {
    FieldCells zoneCells = cells(zone);
    int[] points = new int[zoneCells.count()];
    Arrays.fill(points, -1);
    for (int number = zone.first(); number < zone.end(); number++) {
      DemandPoint point = this.points.get(number);
      points[zoneCells.cellAt(point.x(), point.y())] = number;
    }
    if (grid.equals(zoneCells)) {
      return points;
    }
    Zone place = place(zone);
    int[] pointsOfGrid = new int[grid.count()];
    Arrays.setAll(
        pointsOfGrid,
        cell ->
            place.contains(grid.x(cell), grid.y(cell))
                ? pointNear(grid.x(cell), grid.y(cell), zoneCells, points)
                : -1);
    return pointsOfGrid;
  }

  /**
   * Returns the point of the cell that contains a place; if it has none, the nearest point of the
   * cells around it; else -1.
   */
  private int pointNear(double x, double y, FieldCells cells, int[] pointsByCell) {
    int nearest = pointsByCell[cells.cellAt(x, y)];
    double least = nearest < 0 ? Double.POSITIVE_INFINITY : 0;
    for (int side = 0; side < 9 && least > 0; side++) {
      int cell =
          cells.cellAt(x + (side % 3 - 1) * cells.width(), y + (side / 3 - 1) * cells.height());
      double distance =
          cell < 0 ? Double.POSITIVE_INFINITY : Math.hypot(cells.x(cell) - x, cells.y(cell) - y);
      if (distance < least && pointsByCell[cell] >= 0) {
        nearest = pointsByCell[cell];
        least = distance;
      }
    }
    return nearest;
  }

  /** Returns the demand for the same points with another detection in all zones. */
  public Demand with(Detection detection) {
    List<ZoneDemand> changedZones =
        zones.stream()
            .map(zone -> new ZoneDemand(zone.name, detection, zone.k, zone.first, zone.end))
            .toList();
    return new Demand(site, cells, changedZones, points);
  }

  /**
   * Returns a target that stands at a point.
   *
   * @param model a target from which all other attributes are taken
   */
  public static TargetSpec targetAt(double x, double y, int number, TargetSpec model) {
    return model
        .with(TargetSpec.FEATURES, (double) number)
        .with(TargetSpec.X, x)
        .with(TargetSpec.Y, y)
        .with(TargetSpec.SPEED, 0)
        .with(TargetSpec.MOVE, "Straight")
        .with(TargetSpec.WAYPOINTS, List.of());
  }

  /**
   * Whether all parts of a zone's area are worth the same. Otherwise the weights of points say
   * where targets are.
   */
  public boolean isForArea() {
    return zones.stream()
        .allMatch(
            zone ->
                pointsOf(zone).stream().mapToDouble(DemandPoint::weight).distinct().count() <= 1);
  }

  /** Returns the area of a zone, by which {@code run} measures in the same way. */
  public ZoneArea area(ZoneDemand zone) {
    return new ZoneArea(site, place(zone).demanding(zone.k()), zone.detection());
  }

  /** Returns the element of the site that makes a demand. */
  Zone place(ZoneDemand zone) {
    return site.zones().stream()
        .filter(named -> named.name().equals(zone.name()))
        .findFirst()
        .orElseGet(Zone::ofField);
  }

  /** The sum of the weights of a zone's points. */
  double weight(ZoneDemand zone) {
    return pointsOf(zone).stream().mapToDouble(DemandPoint::weight).sum();
  }

  /** The points of a zone. */
  List<DemandPoint> pointsOf(ZoneDemand zone) {
    return points.subList(zone.first(), zone.end());
  }

  /** Returns for each point the worth of each time that it is covered. */
  public double[] unitWorths() {
    return points.stream().mapToDouble(point -> point.weight() / needs(point)).toArray();
  }

  /** Returns for each point the number of cameras that it needs. */
  public int[] needs() {
    return points.stream().mapToInt(this::needs).toArray();
  }

  private int needs(DemandPoint point) {
    return zones.get(point.zone()).k();
  }

  /**
   * Returns the share of a zone's demand that is met. Points that fewer than k cameras cover count
   * in part.
   *
   * @param counts for each point, the number of cameras that cover it
   */
  public double share(ZoneDemand zone, int[] counts) {
    return share(zone, counts, false);
  }

  /**
   * Returns the share of a zone's demand that is met if only points count that k cameras or more
   * cover.
   *
   * @param counts for each point, the number of cameras that cover it
   */
  public double shareByK(ZoneDemand zone, int[] counts) {
    return share(zone, counts, true);
  }

  private double share(ZoneDemand zone, int[] counts, boolean fullOnly) {
    double total = 0;
    double met = 0;
    for (int number = zone.first(); number < zone.end(); number++) {
      double part = Math.min(1, counts[number] / (double) zone.k());
      total += points.get(number).weight();
      met += points.get(number).weight() * (fullOnly ? Math.floor(part) : part);
    }
    return total == 0 ? 1 : met / total;
  }
}
