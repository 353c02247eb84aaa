package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Reference;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.camsim.CamSimRangeDetection;
import org.hificamsim.core.scenario.Headings;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** The recorded k_min of the coverage study's simulator with all cameras at their widest. */
class CoverageStudyTest {
  @ParameterizedTest
  @ValueSource(strings = {"scenario7", "scenario-w1"})
  void zoomedOutEqualsTheRecordedRun(String name) {
    List<Integer> recorded =
        Reference.rows("coverage-study/" + name + ".expected.csv").stream()
            .map(row -> Integer.parseInt(row[2]))
            .toList();
    Scenario scenario =
        ScenarioReader.read(
                Reference.file("coverage-study/" + name + ".xml"),
                anyMovement -> true,
                new ArrayList<>()::add)
            .withHeadings(Headings.AS_RADIANS);
    List<Integer> ours = new ArrayList<>();
    new Simulation(
            new World(scenario, Movements.registry(), 0),
            new Detection(new CamSimRangeDetection(), 0.3),
            new WidestPolicy(),
            0,
            List.of((StepListener) (network, coverage) -> ours.add(coverage.kMin())))
        .run(recorded.size());
    assertEquals(300, recorded.size());
    assertEquals(recorded, ours);
  }
}
