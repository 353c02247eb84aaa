package org.hificamsim.reproduction.sensitivity;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioEvent;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.TargetSpec;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

class TargetCountTest {
  private static final Path ROOT = Path.of(System.getProperty("hificamsim.root", "."));

  private static Scenario read(String name) {
    return ScenarioReader.read(
        ROOT.resolve("scenarios").resolve(name + ".xml"), movement -> true, warning -> {});
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
  void hasAsManyTargetsAsAskedForEachAtAPlaceOfItsOwn(String name, int number) {
    Scenario changed = TargetCount.of(read(name), number);
    List<TargetSpec> targets = targets(changed);
    assertEquals(number, targets.size());
    assertEquals(number, targets.stream().map(TargetSpec::name).distinct().count());
    assertEquals(number, targets.stream().map(one -> one.x() + "," + one.y()).distinct().count());
    assertEquals(name + "-" + number + "-targets", changed.name());
  }

  @Test
  void keepsTheFilesTargetsFirst() {
    Scenario scenario = read("ring-random");
    assertEquals(scenario.targets(), TargetCount.of(scenario, 6).targets().subList(0, 3));
  }

  @Test
  void furtherScriptedTargetsWalkTheSameWay() {
    List<TargetSpec> targets = targets(TargetCount.of(read("ring-scripted"), 8));
    assertEquals(4, targets.get(3).waypoints().size());
    assertTrue(targets.get(7).waypoints().containsAll(targets.get(0).waypoints()));
  }

  @Test
  void givesTheSameTargetsEveryTime() {
    Scenario scenario = read("lattice-random");
    assertEquals(TargetCount.of(scenario, 8), TargetCount.of(scenario, 8));
  }
}
