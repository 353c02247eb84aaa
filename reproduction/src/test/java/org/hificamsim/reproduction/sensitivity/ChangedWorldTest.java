package org.hificamsim.reproduction.sensitivity;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.ScenarioEvent;
import org.hificamsim.core.scenario.spec.TargetSpec;
import org.hificamsim.hifi.model.PublishedModels;
import org.hificamsim.hifi.optics.Optics;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

class ChangedWorldTest {
  private static final Path ROOT = Path.of(System.getProperty("hificamsim.root", "."));
  private static final Optics OPTICS = PublishedModels.published().optics();

  private static Scenario read(String name) {
    return ScenarioReader.read(
        ROOT.resolve("scenarios").resolve(name + ".xml"), movement -> true, warning -> {});
  }

  @ParameterizedTest
  @ValueSource(strings = {"lattice-random", "lattice-scripted"})
  void changesSizeOfAllTargetsIncludingLaterOnes(String name) {
    Scenario changed = ChangedWorld.withSize(read(name), 0.45);
    List<TargetSpec> targets = new java.util.ArrayList<>(changed.targets());
    changed.events().stream()
        .filter(ScenarioEvent.AddTarget.class::isInstance)
        .forEach(event -> targets.add(((ScenarioEvent.AddTarget) event).target()));
    assertEquals(3, targets.size());
    targets.forEach(target -> assertEquals(0.45, target.size()));
    assertEquals(name + "-q0.45", changed.name());
  }

  @Test
  void heightGivesNarrowestLevelTheFocalLength() {
    Scenario changed = ChangedWorld.withFocalLength(read("ring-random"), OPTICS, 0.05);
    double height = changed.mountHeight().orElseThrow();
    assertEquals(0.05, OPTICS.focalLength(2.5, height), 1e-15);
    assertEquals(0.05 / 3, OPTICS.focalLength(7.5, height), 1e-15);
    assertEquals("ring-random-z0.05", changed.name());
  }

  @ParameterizedTest
  @ValueSource(strings = {"ring-random", "cluster-scripted"})
  void changesSpeedOfAllTargetsAndAllRadii(String name) {
    Scenario changed = ChangedWorld.withWidestRadius(ChangedWorld.withSpeed(read(name), 0.5), 9);
    targets(changed).forEach(target -> assertEquals(0.5, target.speed()));
    assertEquals(List.of(3.0, 4.5, 6.0, 7.5, 9.0), changed.zooms());
    assertEquals(name + "-v0.5-r9.0", changed.name());
  }

  private static List<TargetSpec> targets(Scenario scenario) {
    return scenario.targets().isEmpty()
        ? scenario.events().stream()
            .map(event -> ((ScenarioEvent.AddTarget) event).target())
            .toList()
        : scenario.targets();
  }

  @ParameterizedTest
  @CsvSource({"lattice-random,1", "lattice-random,8", "cluster-scripted,2", "cluster-scripted,8"})
  void hasNumberOfTargetsAtDifferentPositions(String name, int number) {
    Scenario changed = ChangedWorld.withTargets(read(name), number);
    List<TargetSpec> targets = targets(changed);
    assertEquals(number, targets.size());
    assertEquals(number, targets.stream().map(TargetSpec::name).distinct().count());
    assertEquals(
        number, targets.stream().map(target -> target.x() + "," + target.y()).distinct().count());
    assertEquals(name + "-" + number + "-targets", changed.name());
  }

  @Test
  void keepsFirstTargetsOfTheFile() {
    Scenario scenario = read("ring-random");
    assertEquals(scenario.targets(), ChangedWorld.withTargets(scenario, 6).targets().subList(0, 3));
  }

  @Test
  void addedTargetsFollowTheScript() {
    List<TargetSpec> targets = targets(ChangedWorld.withTargets(read("ring-scripted"), 8));
    assertEquals(4, targets.get(3).waypoints().size());
    assertTrue(targets.get(7).waypoints().containsAll(targets.get(0).waypoints()));
  }

  @Test
  void addsTheSameTargetsEachTime() {
    Scenario scenario = read("lattice-random");
    assertEquals(ChangedWorld.withTargets(scenario, 8), ChangedWorld.withTargets(scenario, 8));
  }
}
