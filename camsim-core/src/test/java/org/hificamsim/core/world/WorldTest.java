package org.hificamsim.core.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.Headings;
import org.hificamsim.core.scenario.spec.ScenarioEvent.AddCamera;
import org.hificamsim.core.scenario.spec.ScenarioEvent.AddTarget;
import org.hificamsim.core.scenario.spec.ScenarioEvent.ChangeCamera;
import org.hificamsim.core.scenario.spec.ScenarioEvent.FailCamera;
import org.hificamsim.core.scenario.spec.ScenarioEvent.FailRegistration;
import org.hificamsim.core.scenario.spec.ScenarioEvent.RemoveTarget;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.core.world.movement.Movements;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class WorldTest {
  private static final double EXACT = 0;

  @Test
  void startsWithoutCamerasAndTargetsOfEvents() {
    World world =
        new TestScenario()
            .camera(1, 2)
            .target(3, 4)
            .events(
                new AddTarget(0, TestScenario.target(7, 5, 6, 0, 0)),
                new AddCamera(0, TestScenario.camera("late", 0, 0, 0, 90, 5)))
            .world();
    assertEquals(2, world.cameras().count());
    assertEquals(2, world.targets().count());
    assertTrue(world.cameras().online(0));
    assertTrue(world.targets().present(0));
    assertFalse(world.cameras().online(1));
    assertFalse(world.targets().present(1));
    assertEquals("late", world.cameras().name(1));
    assertEquals("7.0", world.targets().name(1));
    world.fireEvents(0);
    assertTrue(world.cameras().online(1));
    assertTrue(world.targets().present(1));
    assertEquals(5, world.targets().x(1));
  }

  @Test
  void anotherWorldStartsAfreshAndIsIndependent() {
    World world = new TestScenario().zooms(2, 5).camera(1, 2).target(3, 4).world();
    world.moveCamera(0, 8, 9);
    world.cameras().aim(0, 1, Math.PI / 2);
    world.targets().put(0, 6, 7);
    World other = world.another(1);
    assertEquals(1, other.cameras().x(0), EXACT);
    assertEquals(0, other.cameras().pose(0, 1).headingX(), EXACT);
    assertEquals(3, other.targets().x(0), EXACT);
    other.moveCamera(0, -1, -2);
    assertEquals(8, world.cameras().x(0), EXACT);
    assertEquals(1, world.cameras().pose(0, 1).headingX(), 1e-15);
  }

  @Test
  void turnCameraKeepsItsPosition() {
    World world = new TestScenario().camera(1, 2).camera(3, 4).world();
    int before = world.cameras().revision();
    world.turnCamera(1, Math.PI / 3);
    assertEquals(Math.PI / 3, world.cameras().heading(1), EXACT);
    assertEquals(3, world.cameras().x(1), EXACT);
    assertEquals(4, world.cameras().y(1), EXACT);
    assertEquals(0, world.cameras().heading(0), EXACT);
    assertNotEquals(before, world.cameras().revision());
  }

  @Test
  void ordersInitialCamerasBeforeThoseOfEvents() {
    Scenario scenario =
        new TestScenario()
            .camera(1, 2)
            .events(new AddCamera(5, TestScenario.camera("late", 0, 0, 0, 90, 5)))
            .camera(TestScenario.camera("more", 0, 0, 0, 90, 5))
            .scenario()
            .withCameras(camera -> camera.with(CameraSpec.X, 7).with(CameraSpec.HEADING, 45));
    World world = new World(scenario, Movements.registry(), 0);
    world.fireEvents(5);
    assertEquals(List.of("c0", "more", "late"), names(world));
    for (int camera = 0; camera < 3; camera++) {
      assertEquals(7, world.cameras().x(camera), EXACT);
      assertEquals(Math.toRadians(45), world.cameras().heading(camera), EXACT);
    }
  }

  private static List<String> names(World world) {
    return IntStream.range(0, world.cameras().count()).mapToObj(world.cameras()::name).toList();
  }

  @Test
  void eventsFireByStepThenInDocumentOrder() {
    World world =
        new TestScenario()
            .events(
                new AddTarget(5, TestScenario.target(3, 3, 0, 0, 0)),
                new AddTarget(2, TestScenario.target(1, 1, 0, 0, 0)),
                new AddTarget(5, TestScenario.target(4, 4, 0, 0, 0)),
                new AddTarget(2, TestScenario.target(2, 2, 0, 0, 0)))
            .world();
    assertEquals("1.0", world.targets().name(0));
    assertEquals("2.0", world.targets().name(1));
    assertEquals("3.0", world.targets().name(2));
    assertEquals("4.0", world.targets().name(3));
    world.fireEvents(1);
    assertEquals("", present(world));
    world.fireEvents(2);
    assertEquals("01", present(world));
    world.fireEvents(4);
    assertEquals("01", present(world));
    world.fireEvents(5);
    assertEquals("0123", present(world));
    for (int target = 0; target < 4; target++) {
      assertEquals(target + 1, world.targets().x(target), "each where it belongs");
    }
  }

  @Test
  void laterEventOfSameStepWins() {
    World world =
        new TestScenario()
            .camera(0, 0)
            .events(
                new ChangeCamera(3, "c0", 1, 1, 0, 90, 5),
                new ChangeCamera(3, "c0", 2, 2, 0, 90, 5))
            .world();
    world.fireEvents(3);
    assertEquals(2, world.cameras().x(0));
  }

  @Test
  void removedTargetNeitherMovesNorDraws() {
    World world =
        new TestScenario()
            .target(0, 0, 90, 1)
            .target(9.5, 0, 90, 1)
            .events(new RemoveTarget(1, 0))
            .world(0);
    world.fireEvents(0);
    world.moveTargets();
    world.fireEvents(1);
    world.moveTargets();
    assertEquals(1, world.targets().x(0));
    assertFalse(world.targets().present(0));
    assertTrue(world.targets().present(1));
  }

  @Test
  void featuresMayComeBackAfterTheirRemoval() {
    World world =
        new TestScenario()
            .target(TestScenario.target(4.5, 0, 0, 0, 0))
            .events(
                new RemoveTarget(1, 4.5),
                new AddTarget(2, TestScenario.target(4.5, 8, 8, 0, 0)),
                new RemoveTarget(3, 4.5),
                new RemoveTarget(4, 4.5))
            .world();
    world.fireEvents(1);
    assertEquals("", present(world));
    world.fireEvents(2);
    assertEquals("1", present(world));
    assertEquals("4.5", world.targets().name(1));
    world.fireEvents(3);
    assertEquals("", present(world));
    world.fireEvents(4);
    assertEquals("", present(world), "nothing left to remove, nothing happens");
  }

  /** Files cannot have such targets at the same time, but scenarios made in code can. */
  @Test
  void removesFirstOfTargetsWithSameFeatures() {
    World world =
        new TestScenario()
            .target(TestScenario.target(4.5, 0, 0, 0, 0))
            .target(TestScenario.target(4.5, 1, 0, 0, 0))
            .events(new RemoveTarget(1, 4.5), new RemoveTarget(2, 4.5))
            .world();
    world.fireEvents(1);
    assertEquals("1", present(world));
    world.fireEvents(2);
    assertEquals("", present(world));
  }

  @Test
  void changeEventKeepsValuesOfMinusOne() {
    World world =
        new TestScenario()
            .camera(TestScenario.camera("a", 1, 2, 90, 120, 7))
            .camera(TestScenario.camera("b", 1, 2, 90, 120, 7))
            .events(
                new ChangeCamera(1, "a", 3, -1, 180, -1, 9),
                new ChangeCamera(2, "a", -1, 4, -1, 60, -1))
            .world();
    Cameras cameras = world.cameras();
    world.fireEvents(1);
    assertEquals(3, cameras.x(0));
    assertEquals(2, cameras.y(0));
    assertEquals(-1, cameras.pose(0).headingY(), EXACT);
    assertEquals(Math.toRadians(120), cameras.zoom(0, 0).viewingAngle());
    assertEquals(9, cameras.zoom(0, 0).radius());
    world.fireEvents(2);
    assertEquals(3, cameras.x(0));
    assertEquals(4, cameras.y(0));
    assertEquals(-1, cameras.pose(0).headingY(), EXACT);
    assertEquals(Math.toRadians(60), cameras.zoom(0, 0).viewingAngle());
    assertEquals(9, cameras.zoom(0, 0).radius());
    assertEquals(1, cameras.x(1), "the other camera stays");
    assertEquals(7, cameras.zoom(1, 0).radius());
  }

  @ParameterizedTest
  @CsvSource({"0, true", "-1, false", "1, false", "50, false"})
  void errorOfDurationZeroKeepsCameraOnline(int duration, boolean online) {
    World world = new TestScenario().camera(0, 0).events(new FailCamera(2, "c0", duration)).world();
    world.fireEvents(1);
    assertTrue(world.cameras().online(0));
    for (int step = 2; step < 100; step++) {
      world.fireEvents(step);
      assertEquals(online, world.cameras().online(0));
    }
  }

  @Test
  void ignoresEventsForUnknownOrOfflineCameras() {
    World world =
        new TestScenario()
            .camera(0, 0)
            .events(
                new FailCamera(0, "nobody", -1),
                new ChangeCamera(0, "nobody", 9, 9, 9, 9, 9),
                new FailCamera(1, "c0", -1),
                new FailCamera(2, "c0", -1),
                new ChangeCamera(2, "c0", 9, 9, 9, 9, 9),
                new FailRegistration(2, -1))
            .world();
    world.fireEvents(2);
    assertFalse(world.cameras().online(0));
    assertEquals(0, world.cameras().x(0));
  }

  @ParameterizedTest
  @CsvSource({"0, 0", "3.3, 3.3", "19.9, 19.9", "20, 16", "30, 16"})
  void clampsRangesOfTwentyOrMore(double given, double radius) {
    World world =
        new TestScenario()
            .camera(TestScenario.camera("a", 0, 0, 0, 90, given))
            .events(new AddCamera(0, TestScenario.camera("b", 0, 0, 0, 90, given)))
            .world();
    world.fireEvents(0);
    assertEquals(radius, world.cameras().zoom(0, 0).radius());
    assertEquals(radius, world.cameras().zoom(1, 0).radius());
  }

  @Test
  void doesNotClampChangedRange() {
    World world =
        new TestScenario()
            .camera(0, 0)
            .events(new ChangeCamera(0, "c0", -1, -1, -1, -1, 30))
            .world();
    world.fireEvents(0);
    assertEquals(30, world.cameras().zoom(0, 0).radius());
  }

  @Test
  void zoomListOverridesRange() {
    World world =
        new TestScenario()
            .zooms(2, 3.5, 25)
            .camera(TestScenario.camera("a", 0, 0, 0, 90, 7))
            .events(new ChangeCamera(1, "a", -1, -1, -1, 60, 12))
            .world();
    Cameras cameras = world.cameras();
    assertEquals(3, cameras.views(0));
    assertEquals(2, cameras.view(0), "starts at the widest");
    assertEquals(3.5, cameras.zoom(0, 1).radius());
    assertEquals(25, cameras.zoom(0, 2).radius());
    assertEquals(2, cameras.zoom(0, 1).narrowestRadius());
    assertEquals(25, cameras.zoom(0, 1).widestRadius());
    assertTrue(Double.isNaN(cameras.zoom(0, 1).mountHeight()));
    cameras.turnTo(0, 1);
    world.fireEvents(1);
    assertEquals(3.5, cameras.zoom(0, 1).radius());
    assertEquals(1, cameras.view(0), "a change keeps the zoom level");
    assertEquals(Math.toRadians(60), cameras.zoom(0, 1).viewingAngle());
  }

  @Test
  void revisionChangesOnlyWithTheCameras() {
    World world =
        new TestScenario()
            .camera(0, 0)
            .target(0, 0, 0, 1)
            .events(
                new AddCamera(1, TestScenario.camera("b", 0, 0, 0, 90, 5)),
                new ChangeCamera(2, "b", -1, -1, -1, -1, -1),
                new FailCamera(3, "b", -1),
                new FailCamera(4, "b", -1),
                new RemoveTarget(5, 0),
                new AddTarget(5, TestScenario.target(1, 0, 0, 0, 0)))
            .world();
    for (int step = 0; step < 7; step++) {
      int before = world.cameras().revision();
      world.fireEvents(step);
      if (step >= 1 && step <= 3) {
        assertNotEquals(before, world.cameras().revision(), "step " + step);
      } else {
        assertEquals(before, world.cameras().revision(), "step " + step);
      }
      world.moveTargets();
      world.cameras().turnTo(0, 0);
    }
  }

  @Test
  void readsHeadingsInUnitOfScenario() {
    TestScenario scenario = new TestScenario().target(0, 0, 2, 1);
    World asRadians =
        new World(
            scenario.scenario().with(Scenario.HEADINGS, Headings.AS_RADIANS),
            Movements.registry(),
            0);
    assertEquals(2, asRadians.targets().heading(0));
    assertEquals(Math.toRadians(2), scenario.world().targets().heading(0));
  }

  @ParameterizedTest
  @CsvSource({"NoSuchBrownian, DirectedBrownian", "straight, Straight"})
  void rejectsUnknownMovementAndListsNearestNames(String name, String known) {
    TestScenario scenario =
        new TestScenario().target(TestScenario.target(1, 0, 0, 0, 0).with(TargetSpec.MOVE, name));
    InputException error = assertThrows(InputException.class, scenario::world);
    assertTrue(error.getMessage().contains(name), error.getMessage());
    assertTrue(error.getMessage().contains("expected one of"), error.getMessage());
    assertTrue(error.getMessage().contains(known + ","), error.getMessage());
  }

  @Test
  void targetsOfSameMovementShareNoState() {
    World world =
        new TestScenario()
            .target(TestScenario.walker(1, "Scripted", 1, 0, 0, 1, 0, 1, 5))
            .target(TestScenario.walker(2, "Scripted", 1, 0, 0, 9, 0, 9, 5))
            .world();
    for (int i = 0; i < 4; i++) {
      world.moveTargets();
    }
    assertEquals(3, world.targets().y(0));
    assertEquals(4, world.targets().x(1));
  }

  private static String present(World world) {
    StringBuilder text = new StringBuilder();
    for (int target = 0; target < world.targets().count(); target++) {
      text.append(world.targets().present(target) ? target : "");
    }
    return text.toString();
  }

  @Test
  void restartedWorldEqualsNewOne() {
    TestScenario scenario =
        new TestScenario()
            .camera(1, 2)
            .target(TestScenario.walker(0, "Brownian", 1, 3, 4))
            .events(new AddTarget(1, TestScenario.target(7, 5, 6, 0, 0)));
    World world = scenario.world(1);
    walk(world);
    world.moveCamera(0, 8, 9);
    world.restart(2);
    assertEquals(1, world.cameras().x(0), EXACT);
    assertFalse(world.targets().present(1));
    World another = scenario.world(2);
    walk(world);
    walk(another);
    assertEquals(another.targets().x(0), world.targets().x(0), EXACT);
    assertTrue(world.targets().present(1));
  }

  private static void walk(World world) {
    for (int step = 0; step < 5; step++) {
      world.fireEvents(step);
      world.moveTargets();
    }
  }

  @Test
  void notifiesObserverOfEachEvent() {
    World world =
        new TestScenario()
            .camera(1, 2)
            .target(3, 4)
            .events(
                new AddCamera(1, TestScenario.camera("late", 0, 0, 0, 90, 5)),
                new FailCamera(2, "c0", 3),
                new AddTarget(3, TestScenario.target(7, 5, 6, 0, 0)),
                new RemoveTarget(4, 0))
            .world();
    List<String> notifications = new ArrayList<>();
    world.observe(
        new WorldObserver() {
          @Override
          public void cameraAdded(int camera) {
            notifications.add("camera " + camera);
          }

          @Override
          public void cameraFailed(int camera, int duration) {
            notifications.add("camera " + camera + " off for " + duration);
          }

          @Override
          public void targetAppeared(int target) {
            notifications.add("target " + target);
          }

          @Override
          public void targetVanished(int target) {
            notifications.add("no target " + target);
          }
        });
    world.fireEvents(9);
    assertEquals(
        List.of("camera 1", "camera 0 off for 3", "target 1", "no target 0"), notifications);
  }

  @Test
  void switchesCameraAndChangesItsRange() {
    World world = new TestScenario().camera(1, 2).target(3, 4).world();
    world.switchCamera(0, false);
    assertFalse(world.cameras().online(0));
    world.switchCamera(0, true);
    assertTrue(world.cameras().online(0));
    world.changeRange(0, 8);
    assertEquals(8, world.cameras().zoom(0, 0).radius());
    assertEquals(2 * Math.PI, world.cameras().zoom(0, 0).viewingAngle());
  }

  @Test
  void listsZoomLevelsOfCamerasOnce() {
    Scenario scenario = new TestScenario().zooms(2, 5).camera(1, 2).camera(3, 4).scenario();
    assertEquals(
        List.of(2.0, 5.0), World.zoomLevels(scenario).stream().map(zoom -> zoom.radius()).toList());
    assertEquals(2, World.zoomLevels(scenario, scenario.cameras().get(1)).size());
  }

  @Test
  void returnsSpecsOfCamerasAndTargets() {
    World world =
        new TestScenario()
            .camera(1, 2)
            .target(TestScenario.target(0, 3, 4, 0, 0).withSize(1.5))
            .events(new AddCamera(1, TestScenario.camera("late", 0, 0, 0, 90, 5)))
            .world();
    assertEquals("late", world.cameraSpec(1).name());
    assertEquals(1.5, world.targetSpec(0).size());
    assertEquals(1.5, world.targets().size(0));
    assertEquals(world.targetSpec(0).width(), world.targets().width(0));
  }

  @Test
  void registersMovementsUnderTheirNames() {
    for (String name : Movements.registry().names()) {
      assertEquals(name, Movements.registry().create(name).name());
    }
  }
}
