package org.hificamsim.placement.site;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Zone;
import org.hificamsim.presentation.view.Planner;
import org.junit.jupiter.api.Test;

/** Tests the quick plans of the live view. */
class SitePlannerTest {
  private static final Catalogue CATALOGUE = Catalogue.load();
  private static final Detection DETECTION =
      Detection.of(CATALOGUE.detections().create("oodpcvs-2025:level=validate"));

  private static final Planner.Watcher NOBODY =
      new Planner.Watcher() {
        @Override
        public void progressed(String event, double share) {}

        @Override
        public boolean isStopped() {
          return false;
        }
      };

  /** A zone so far from the border that no camera there sees enough. */
  private static final Scenario HALL =
      new Scenario("hall", new Field(0, 60, 0, 60))
          .with(Scenario.MOUNT_HEIGHT, 4.0)
          .with(
              Scenario.OBSTACLES,
              List.of(new Obstacle.Pillar(5, 5, 0.5, 0).between(0, 2))) // a site with heights
          .with(
              Scenario.ZONES,
              List.of(
                  Zone.of(
                      "middle",
                      Zone.Shape.RECTANGLE,
                      List.of(new Point(29, 29), new Point(31, 31)))));

  private final Planner planner =
      new SitePlanner(CATALOGUE, name -> DETECTION, PriceList.generic());

  @Test
  void hangsCamerasOnCeilingOnlyIfAsked() {
    InputException unseen = assertThrows(InputException.class, () -> plan(false));
    assertTrue(
        unseen.getMessage().startsWith("zone 'middle' is seen from none"), unseen::getMessage);
    Planner.Plan plan = plan(true);
    assertEquals(1, plan.cameras().size());
    assertTrue(plan.claim().contains("of the demand is met"), plan.claim());
    assertTrue(plan.cameras().get(0).z().isEmpty(), "it hangs as high as all cameras");
    assertEquals(30, plan.cameras().get(0).x(), 10);
  }

  private Planner.Plan plan(boolean ceiling) {
    return planner.plan(
        HALL, DETECTION, new Planner.Request(Planner.Goal.CAMERAS, 1, false, ceiling), NOBODY);
  }
}
