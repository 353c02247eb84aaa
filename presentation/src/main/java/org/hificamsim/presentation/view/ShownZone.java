package org.hificamsim.presentation.view;

import com.fasterxml.jackson.annotation.JsonInclude;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.hifi.density.DensityDetections;

/**
 * A zone as pages show it.
 *
 * @param points the points in metres; see {@link Zone}
 * @param demand the level that the zone asks for, in words
 * @param facing the heading of the faces that have to be seen, in degrees; null for any
 * @param met the share of the demand that is met, in [0, 1]; null if it is not known
 */
record ShownZone(
    String name,
    Zone.Shape shape,
    List<Point> points,
    String demand,
    @JsonInclude(JsonInclude.Include.NON_NULL) Double facing,
    @JsonInclude(JsonInclude.Include.NON_NULL) Double met) {

  /**
   * Returns the zones of a site; the whole field if it has none.
   *
   * @param shares for each zone, the shares that are met; empty if they are not known
   */
  static List<ShownZone> of(Scenario site, Detection usual, List<Planner.Share> shares) {
    List<ShownZone> shown = new ArrayList<>();
    for (Zone zone : Zone.ofSite(site.zones())) {
      Zone asked = zone.withDefaults(usual.name(), site.objective());
      Double met = shares.isEmpty() ? null : shares.get(shown.size()).met();
      shown.add(
          new ShownZone(
              zone.name(), zone.shape(), zone.points(), demand(asked), zone.facing(), met));
    }
    return shown;
  }

  private static String demand(Zone asked) {
    String level = DensityDetections.levelName(asked.detection());
    String faces = asked.asksForFaces() ? ", faces" : "";
    return level + (asked.k() > 1 ? " by %s cameras".formatted(asked.k()) : "") + faces;
  }
}
