package org.hificamsim.core.engine;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Reference;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.camsim.CamSimRangeDetection;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.Headings;
import org.hificamsim.core.world.World;
import org.hificamsim.core.world.movement.Movements;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Compares k_min with the simulator of the coverage study, with all cameras at their widest. */
class CoverageStudyTest {
  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4, 5})
  void widestZoomEqualsRecordedRun(int number) {
    String name = "own-coverage/own-" + number;
    List<Integer> recorded =
        Reference.rows(name + ".expected.csv").stream()
            .map(row -> Integer.parseInt(row[2]))
            .toList();
    List<Integer> ours = new ArrayList<>();
    new Simulation(
            new World(scenario(Reference.file(name + ".xml")), Movements.registry(), 0),
            new Detection(new CamSimRangeDetection(), 0.3),
            new WidestPolicy(),
            0,
            List.of((StepListener) (network, coverage) -> ours.add(coverage.kMin())))
        .run(recorded.size());
    assertEquals(200, recorded.size());
    assertEquals(recorded, ours);
  }

  private static Scenario scenario(Path file) {
    return ScenarioReader.read(file, anyMovement -> true, new ArrayList<>()::add)
        .with(Scenario.HEADINGS, Headings.AS_RADIANS);
  }
}
