package org.hificamsim.reproduction.ladder;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.core.scenario.spec.Occlusion;
import org.hificamsim.core.scenario.spec.OpticsLaw;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.reproduction.ladder.Rungs.Rung;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the rungs of the world with a scenario that has everything that rungs remove. */
class WorldRungsTest {
  private static final Path ROOT = Path.of(System.getProperty("hificamsim.root", "."));
  private static final Scenario HALL = site("hall");
  private static final List<Rung> RUNGS = Rungs.ofWorld(Optional.empty());

  private static Scenario site(String name) {
    return ScenarioReader.read(
        ROOT.resolve("scenarios/" + name + ".xml"), movement -> true, warning -> {});
  }

  private static Scenario world(String rung) {
    return Rungs.ofWorld(Optional.empty(), rung).world().apply(HALL);
  }

  private static List<OpticsSpec> optics(Scenario scenario) {
    return scenario.everyCamera().flatMap(camera -> camera.optics().stream()).toList();
  }

  private static Set<Double> sizes(Scenario scenario) {
    return scenario.targets().stream().map(TargetSpec::size).collect(Collectors.toSet());
  }

  @Test
  void topRungIsUnchangedScenario() {
    assertSame(HALL, world("occlusion"));
    assertEquals("occlusion", RUNGS.get(RUNGS.size() - 1).name());
  }

  @Test
  void wallsRungHasOneTargetSizeAndNoOcclusion() {
    Scenario walls = world("walls");
    assertEquals("hall-walls", walls.name());
    assertEquals(Occlusion.NONE, walls.occlusion());
    assertEquals(HALL.obstacles(), walls.obstacles());
    assertEquals(2, sizes(HALL).size());
    double narrow = Math.sqrt(0.5 * 1.75);
    double wide = Math.sqrt(0.9 * 1.75);
    assertEquals(1, sizes(walls).size());
    assertEquals((16 * narrow + 2 * wide) / 18, sizes(walls).iterator().next(), 1e-12);
    assertEquals(HALL.cameras(), walls.cameras());
  }

  @Test
  void timeRungHasNoWalls() {
    assertTrue(world("time").obstacles().isEmpty());
    assertTrue(optics(world("time")).stream().allMatch(OpticsSpec::takesTime));
    assertEquals(1, sizes(world("time")).size());
  }

  @Test
  void panRungMovesAtOnce() {
    Scenario pan = world("pan");
    assertTrue(optics(pan).stream().noneMatch(OpticsSpec::takesTime));
    assertEquals(
        optics(HALL).stream().map(OpticsSpec::pans).toList(),
        optics(pan).stream().map(OpticsSpec::pans).toList());
  }

  @Test
  void opticsRungDoesNotTurn() {
    Scenario optics = world("optics");
    assertTrue(optics(optics).stream().allMatch(spec -> spec.pans().equals(List.of(0.0))));
    assertEquals(
        optics(HALL).stream().map(OpticsSpec::anglesOfView).toList(),
        optics(optics).stream().map(OpticsSpec::anglesOfView).toList());
  }

  @Test
  void roundRungHasRadiiFromMountHeight() {
    Scenario round = world("round");
    assertTrue(optics(round).stream().allMatch(spec -> spec.law() == OpticsLaw.ROUND));
    assertTrue(round.everyCamera().allMatch(camera -> camera.viewingAngle() == 360));
    double height = round.mountHeight().orElseThrow();
    List<Double> angles = optics(HALL).get(0).anglesOfView();
    assertEquals(angles.size(), round.zooms().size());
    for (int i = 0; i < angles.size(); i++) {
      double radius = height * Math.tan(Math.toRadians(angles.get(i)) / 2);
      assertEquals(radius, round.zooms().get(i), 1e-9);
    }
    assertEquals(Math.hypot(50, 30) / 2, round.zooms().get(angles.size() - 1), 1e-9);
  }

  @Test
  void everyRungCanBeWrittenAndRead(@TempDir Path folder) throws IOException {
    for (Rung rung : RUNGS) {
      String text = ScenarioWriter.write(rung.world().apply(HALL));
      Path file = Files.writeString(folder.resolve(rung.name() + ".xml"), text);
      Scenario read = ScenarioReader.read(file, movement -> true, warning -> {});
      assertEquals(text, ScenarioWriter.write(read), rung.name());
    }
  }

  @Test
  void laterTargetsHaveTheSameSize() {
    assertFalse(HALL.events().isEmpty());
    String text = ScenarioWriter.write(world("walls"));
    assertFalse(text.contains(" width=\"0.5\""), text);
  }

  @Test
  void rejectsScenarioWithoutLens() {
    Scenario ring = site("ring-random");
    InputException fault =
        assertThrows(
            InputException.class,
            () -> Rungs.ofWorld(Optional.empty(), "round").world().apply(ring));
    assertTrue(fault.getMessage().contains("'ring-random' has no camera with law"));
  }

  @Test
  void rejectsUnknownRung() {
    InputException fault =
        assertThrows(InputException.class, () -> Rungs.ofWorld(Optional.empty(), "lens"));
    assertTrue(fault.getMessage().endsWith("round, optics, pan, time, walls, occlusion"));
  }
}
