package org.hificamsim.placement.site;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.placement.site.Demand.ZoneDemand;
import org.hificamsim.runs.cells.FieldCells;
import org.hificamsim.solver.cover.CoverInstance;

/**
 * The part of a demand that cameras cover.
 *
 * @param covered for each camera, the points that it covers, rising
 * @param area what the cameras see of each zone's area
 */
public record PlanCover(Demand demand, List<CameraSpec> cameras, int[][] covered, PlanArea area) {
  /** Measures cameras. */
  public static PlanCover of(
      Demand demand, PointSight sight, List<CameraSpec> cameras, CoverageReading reading) {
    return of(demand, sight, cameras, reading, () -> {});
  }

  /**
   * Measures cameras.
   *
   * @param measured action to run after each zone has been measured
   */
  public static PlanCover of(
      Demand demand,
      PointSight sight,
      List<CameraSpec> cameras,
      CoverageReading reading,
      Runnable measured) {
    return new PlanCover(
        demand,
        cameras,
        sight.covered(cameras, reading),
        PlanArea.of(demand, sight, cameras, reading, measured));
  }

  /** Returns for each point the number of cameras that cover it. */
  public int[] counts() {
    return countsWithout(-1);
  }

  /** Returns for each point the number of cameras that cover it after the failure of one. */
  public int[] countsWithout(int failed) {
    int[] working = IntStream.range(0, cameras.size()).filter(camera -> camera != failed).toArray();
    return instance().counts(working);
  }

  private CoverInstance instance() {
    double[] prices = cameras.stream().mapToDouble(CameraSpec::price).toArray();
    return new CoverInstance(demand.unitWorths(), demand.needs(), covered, prices);
  }

  /** The share of the demand that is met if points are covered this often. */
  public double share(int[] counts) {
    CoverInstance instance = instance();
    return instance.worth(counts) / instance.totalWorth();
  }

  /** The share of the demand that the cameras meet. */
  public double share() {
    return share(counts());
  }

  /** The shares of the demand that are met after the failure of each camera. */
  public double[] sharesWithout() {
    return IntStream.range(0, cameras.size())
        .mapToDouble(camera -> share(countsWithout(camera)))
        .toArray();
  }

  /** The share that is claimed to be met: of the area, or of where targets are. */
  public double claimedShare() {
    return demand.isForArea() ? area.share() : share();
  }

  /** The share of a zone that is claimed to be met. */
  public double claimedShare(ZoneDemand zone) {
    return demand.isForArea()
        ? area.zones().get(demand.zones().indexOf(zone)).share()
        : demand.share(zone, counts());
  }

  /** The price of all cameras. */
  public double price() {
    return cameras.stream().mapToDouble(CameraSpec::price).sum();
  }

  /**
   * Returns the connected parts of zones that are not seen as demanded, the largest first: what the
   * claimed shares leave.
   */
  public List<BlindSpot> blindSpots() {
    if (demand.isForArea()) {
      return area.blindSpots();
    }
    int[] counts = counts();
    return BlindSpot.largestFirst(
        demand.zones().stream().flatMap(zone -> blindCells(zone, counts).stream()));
  }

  /** Returns the parts of a zone where targets are that are not seen as demanded. */
  private List<BlindSpot> blindCells(ZoneDemand zone, int[] counts) {
    FieldCells cells = demand.cells(zone);
    double[] missing =
        Arrays.stream(demand.pointsByCell(zone, cells))
            .mapToDouble(point -> point < 0 ? 0 : 1 - Math.min(1, 1.0 * counts[point] / zone.k()))
            .toArray();
    return BlindSpot.of(zone.name(), cells, missing);
  }
}
