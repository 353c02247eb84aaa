package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.Reference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Compares {@code run} with the results of the coverage study's simulator (docs/evidence.md). */
class CoverageStudyTest {
  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(ints = {0, 1, 2, 3, 4, 5})
  void ownScenariosHaveTheRecordedKMin(int number) throws IOException {
    assertEquals(200, comparedSteps("own-coverage/own-" + number));
  }

  @Test
  void scenariosOfTheStudyHaveTheRecordedKMin() throws IOException {
    List<Path> scenarios = Reference.scenarios("coverage-study");
    assertEquals(11, scenarios.size());
    scenarios.forEach(file -> Cli.assertValidAndRuns(file, folder));
    assertEquals(300, comparedSteps("coverage-study/scenario7"));
    assertEquals(300, comparedSteps("coverage-study/scenario-w1"));
  }

  /** Compares both policies in each step; returns the number of steps. */
  private int comparedSteps(String name) throws IOException {
    Path recorded = Reference.file(name + ".expected.csv");
    Path scenario = Reference.file(name + ".xml");
    List<String> optimal = column(recorded, 1);
    assertEquals(optimal, kMin(scenario, "optimal", optimal.size()), name);
    assertEquals(column(recorded, 2), kMin(scenario, "zoom-out", optimal.size()), name);
    return optimal.size();
  }

  private List<String> kMin(Path scenario, String policy, int steps) throws IOException {
    Cli run =
        Cli.run(
            "run",
            scenario,
            "--detection",
            "camsim-range",
            "--threshold",
            "0.3",
            "--policy",
            policy,
            "--steps",
            steps,
            "--seed",
            0,
            "--headings",
            "as-radians",
            "--out",
            folder);
    assertEquals(0, run.exit(), run.err());
    return column(folder.resolve("steps.csv"), 2);
  }

  private static List<String> column(Path csv, int column) throws IOException {
    return Files.readAllLines(csv).stream().skip(1).map(row -> row.split(",")[column]).toList();
  }
}
