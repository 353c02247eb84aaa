package org.hificamsim.core.world;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.OptionalInt;
import org.hificamsim.core.TestScenario;
import org.hificamsim.core.detection.Condition;
import org.hificamsim.core.detection.Conditions;
import org.hificamsim.core.scenario.AgentSpec;
import org.hificamsim.core.scenario.CameraSpec;
import org.hificamsim.core.scenario.Moving;
import org.hificamsim.core.scenario.Occlusion;
import org.hificamsim.core.scenario.OpticsLaw;
import org.hificamsim.core.scenario.OpticsSpec;
import org.hificamsim.core.scenario.ScenarioEvent;
import org.hificamsim.core.scenario.Surroundings;
import org.junit.jupiter.api.Test;

/** Under which conditions cameras see: their own, else the scenario's, at every zoom level. */
class ConditionsTest {
  private static final double NONE = Double.NaN;

  private static final OpticsSpec LENS =
      new OpticsSpec(
          "lens",
          OpticsLaw.PINHOLE,
          OptionalInt.empty(),
          List.of(20.0, 60.0),
          OptionalDouble.empty(),
          List.of(0.0),
          OptionalDouble.empty(),
          0,
          Moving.BLIND);

  @Test
  void aCamerasOwnGoBeforeTheScenarios() {
    World world =
        new TestScenario()
            .camera(camera("a", Optional.empty(), new Conditions(2.8, NONE, NONE)))
            .camera(camera("b", Optional.of(LENS), new Conditions(NONE, 0.1, 0.5)))
            .camera(camera("c", Optional.of(LENS), Conditions.UNKNOWN))
            .surroundings(under(new Conditions(11, NONE, 2)))
            .world();
    assertEquals(new Conditions(2.8, NONE, 2), world.cameras().zoom(0, 0).conditions());
    assertEquals(new Conditions(11, 0.1, 0.5), world.cameras().zoom(1, 1).conditions());
    assertEquals(new Conditions(11, NONE, 2), world.cameras().zoom(2, 0).conditions());
  }

  @Test
  void stayWhenACameraIsChanged() {
    Conditions own = new Conditions(NONE, NONE, 0.25);
    World world =
        new TestScenario()
            .camera(camera("a", Optional.empty(), own))
            .events(new ScenarioEvent.ChangeCamera(0, "a", 1, 1, -1, -1, 7))
            .world();
    world.fireEvents(0);
    assertEquals(7, world.cameras().zoom(0, 0).radius());
    assertEquals(own, world.cameras().zoom(0, 0).conditions());
  }

  @Test
  void stayWhenASpecIsChanged() {
    Conditions own = new Conditions(4, 0.01, 0.25);
    CameraSpec camera = camera("a", Optional.empty(), own);
    assertEquals(own, camera.standing(3, 4, 5).named("b").through(LENS, 60).conditions());
    Surroundings around = under(own).withoutFloorplan().with(Occlusion.TARGETS).with(List.of());
    assertEquals(own, around.conditions());
    assertSame(Occlusion.TARGETS, around.occlusion());
  }

  @Test
  void areKnownByName() {
    Conditions conditions = new Conditions(2, -0.5, 3);
    assertEquals(2, conditions.value(Condition.APERTURE));
    assertEquals(-0.5, conditions.value(Condition.DISTORTION));
    assertEquals(3, conditions.value(Condition.LIGHT));
    assertTrue(Double.isNaN(Conditions.UNKNOWN.value(Condition.LIGHT)));
    assertEquals(Conditions.UNKNOWN, new Conditions(NONE, NONE, NONE));
  }

  private static CameraSpec camera(String name, Optional<OpticsSpec> optics, Conditions own) {
    return new CameraSpec(name, 0, 0, 0, 60, 5, AgentSpec.NONE, optics, own, Map.of());
  }

  private static Surroundings under(Conditions conditions) {
    return new Surroundings(List.of(), Occlusion.NONE, Optional.empty(), conditions);
  }
}
