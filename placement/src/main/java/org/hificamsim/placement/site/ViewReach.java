package org.hificamsim.placement.site;

import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.placement.site.Demand.DemandPoint;
import org.hificamsim.placement.site.Demand.ZoneDemand;

/**
 * The distances at which people are seen in the middle of a camera's view, if nothing is in the
 * way.
 *
 * @param near the least distance, in metres
 * @param far the greatest distance, in metres; 0 if nobody is seen
 */
public record ViewReach(double near, double far) {
  private static final int SAMPLES = 400;

  /**
   * A line through the middle of a view, which begins at the camera.
   *
   * @param heading the heading in radians, 0 is +y and pi/2 is +x
   * @param length the length in metres
   */
  public record Axis(CameraSpec camera, double heading, double length) {
    private DemandPoint point(int number) {
      double distance = distance(number);
      double x = camera.x() + distance * StrictMath.sin(heading);
      return new DemandPoint(x, camera.y() + distance * StrictMath.cos(heading), 0, 1);
    }

    private double distance(int number) {
      return (number + 1) * length / SAMPLES;
    }

    /** Returns the distances at which people who stand on this line are detected. */
    public ViewReach reach(Demand demand, Detection detection, Catalogue catalogue) {
      Scenario empty =
          demand.site().with(Scenario.OBSTACLES, List.of()).with(Scenario.ZONES, List.of());
      ZoneDemand zone = new ZoneDemand("axis", detection, 1, 0, SAMPLES);
      List<DemandPoint> points = IntStream.range(0, SAMPLES).mapToObj(this::point).toList();
      PointSight sight =
          new PointSight(new Demand(empty, List.of(), List.of(zone), points), catalogue);
      int[] seen = sight.covered(List.of(camera), CoverageReading.FIXED)[0];
      return seen.length == 0
          ? new ViewReach(0, 0)
          : new ViewReach(seen[0] == 0 ? 0 : distance(seen[0]), distance(seen[seen.length - 1]));
    }
  }
}
