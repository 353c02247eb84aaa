package org.hificamsim.presentation.view;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Floorplan;
import org.hificamsim.core.scenario.spec.Zone;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests edits of a scenario: obstacles, zones, the scale, and plans. */
class EditedScenarioTest {
  private static final CameraSpec CAMERA = new CameraSpec("A", 1, 2, 5);

  private final EditedScenario site =
      new EditedScenario(
          new Scenario("shop", new Field(0, 20, 0, 12))
              .withFloorplan(new Floorplan("floor.png", new Field(0, 20, 0, 12)))
              .with(Scenario.CAMERAS, List.of(CAMERA)));

  @Test
  void drawsEachKindOfObstacleWithItsHeight() {
    site.addObstacle(DrawnObstacle.WALL, new Point(5, 5), new Point(9, 5), null);
    site.addObstacle(DrawnObstacle.SHELF, new Point(5, 7), new Point(9, 8), 1.8);
    site.addObstacle(DrawnObstacle.PILLAR, new Point(15, 5), new Point(15.3, 5.4), null);
    List<Obstacle> drawn = site.current().obstacles();
    assertTrue(drawn.get(0).full() && drawn.get(0).contains(7, 5));
    assertEquals(1.8, drawn.get(1).height());
    assertTrue(drawn.get(1).contains(5, 8) && drawn.get(1).contains(8.9, 7.1));
    assertTrue(drawn.get(2).contains(15, 4.51) && !drawn.get(2).contains(15, 4.49));
    site.undo();
    assertEquals(2, site.current().obstacles().size());
  }

  @ParameterizedTest
  @CsvSource({
    "SHELF, 3, 3, 3, 5, 1, area",
    "SHELF, 3, 3, 4, 5, -1, height",
    "PILLAR, 3, 3, 3, 3, 1, both ends",
    "PILLAR, 1, 3, 1, 1, 1, the pillar hits a camera",
    "WALL, 3, 3, 21, 3, 1, in the field"
  })
  void rejectsInvalidObstacles(
      DrawnObstacle shape,
      double x1,
      double y1,
      double x2,
      double y2,
      double height,
      String expected) {
    InputException rejected =
        assertThrows(
            InputException.class,
            () -> site.addObstacle(shape, new Point(x1, y1), new Point(x2, y2), height));
    assertTrue(rejected.getMessage().contains(expected), rejected.getMessage());
    assertEquals(List.of(), site.current().obstacles());
  }

  @Test
  void namesZonesAndRejectsNamesThatAreTaken() {
    site.addZone(zone("", 90.0, null));
    site.addZone(zone("", null, null));
    assertEquals(
        List.of("zone-1", "zone-2"), site.current().zones().stream().map(Zone::name).toList());
    assertEquals(90.0, site.current().zones().get(0).facing());
    assertThrows(InputException.class, () -> site.addZone(zone("zone-2", null, null)));
    assertThrows(InputException.class, () -> site.addZone(zone("flat", null, 20.0)));
    site.removeZone(0);
    assertEquals("zone-2", site.current().zones().get(0).name());
  }

  private static Zone zone(String name, Double facing, Double depression) {
    return new ZoneDraft(name, "oodpcvs-2025:level=perceive", 1, facing, depression)
        .between(new Point(3, 3), new Point(6, 5));
  }

  @Test
  void scalesPlacesButNotHeights() {
    site.addObstacle(DrawnObstacle.SHELF, new Point(5, 7), new Point(9, 8), 1.8);
    site.addObstacle(DrawnObstacle.PILLAR, new Point(15, 5), new Point(15.4, 5), 2.5);
    site.addZone(zone("till", null, null));
    site.scale(new Point(0, 0), new Point(3, 4), 10);
    Scenario scaled = site.current();
    assertEquals(new Field(0, 40, 0, 24), scaled.field());
    assertEquals(scaled.field(), scaled.floorplan().orElseThrow().area());
    assertEquals(new Point(18, 16), ((Obstacle.Polygon) scaled.obstacles().get(0)).points().get(2));
    assertEquals(new Obstacle.Pillar(30, 10, 0.8, 0, 0, 2.5), scaled.obstacles().get(1));
    assertEquals(new Point(12, 10), scaled.zones().get(0).points().get(1));
    assertEquals(4, scaled.cameras().get(0).y());
    assertEquals(1.8, scaled.obstacles().get(0).height());
    assertThrows(
        InputException.class, () -> site.scale(new Point(1, 1), new Point(1, 1), 10), "no length");
  }

  @Test
  void takesPlanOnlyForUnchangedSite() {
    Scenario planned = site.current();
    site.usePlan(planned, List.of(CAMERA.with(CameraSpec.NAME, "P1")));
    assertEquals("P1", site.current().cameras().get(0).name());
    site.addObstacle(DrawnObstacle.WALL, new Point(5, 5), new Point(9, 5), null);
    assertThrows(InputException.class, () -> site.usePlan(planned, List.of(CAMERA)));
    assertEquals("P1", site.current().cameras().get(0).name());
  }

  @Test
  void hangsAllCamerasAtAnotherHeight() {
    assertThrows(InputException.class, () -> site.hangAt(4), "the scenario gives none");
    EditedScenario hall =
        new EditedScenario(
            new Scenario("hall", new Field(0, 20, 0, 12))
                .with(Scenario.MOUNT_HEIGHT, 3.0)
                .with(Scenario.CAMERAS, List.of(CAMERA.with(CameraSpec.Z, 3.0))));
    hall.hangAt(4.5);
    assertEquals(4.5, hall.current().mountHeight().orElseThrow());
    assertTrue(hall.current().cameras().get(0).z().isEmpty());
    assertThrows(InputException.class, () -> hall.hangAt(0));
    hall.hangAt(0.05);
    assertEquals(0.05, hall.current().mountHeight().orElseThrow(), "as files may have it");
    hall.undo();
    assertThrows(InputException.class, () -> hall.hangAt(Double.NaN));
    hall.undo();
    assertEquals(3, hall.current().mountHeight().orElseThrow());
  }
}
