package org.hificamsim.network;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.CamSimCommand;
import org.hificamsim.core.Reference;
import org.hificamsim.network.rules.RandomZoomScenario;
import org.hificamsim.network.rules.RuleRun;
import org.hificamsim.network.statistics.StepFigures;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Compares zooming cameras with a plain transcription of docs/camsim-behaviour.md. */
class ZoomRulesTest {
  private static final int SCENARIOS = 100;

  @TempDir Path folder;

  @Test
  void randomZoomRunsFollowTheRules() throws IOException {
    int handovers = 0;
    for (int seed = 0; seed < SCENARIOS; seed++) {
      RandomZoomScenario random = new RandomZoomScenario(seed);
      Path file = folder.resolve(seed + ".xml");
      Files.writeString(file, random.xml());
      for (StepFigures row : assertFollowsRules(file.toString(), random.options())) {
        handovers += row.handovers();
      }
    }
    assertTrue(handovers > SCENARIOS, handovers + " handovers");
  }

  @Test
  void recordedZoomRunsFollowTheRules() throws IOException {
    for (String[] row : Reference.rows("own-camsim/index.csv")) {
      if (row[1].contains("BanditSolverZoom")) {
        assertFollowsRules("own-camsim/" + row[0], row[1]);
      }
    }
  }

  private static List<StepFigures> assertFollowsRules(String scenario, String options)
      throws IOException {
    CamSimCommand command = CamSimCommand.of(scenario, options);
    RuleRun rules = new RuleRun(Files.readString(Reference.file(scenario)), command);
    List<StepFigures> rows = new ArrayList<>();
    new RecordedRun(command)
        .run(
            (world, network) -> {
              assertEquals(
                  rules.step(rows.size()), network.figures(), () -> scenario + " " + options);
              rows.add(network.figures());
            });
    assertEquals(command.steps(), rows.size());
    return rows;
  }
}
