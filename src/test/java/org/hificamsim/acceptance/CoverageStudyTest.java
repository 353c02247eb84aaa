package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The coverage study's recorded runs, through the command line. */
class CoverageStudyTest {
  @TempDir Path folder;

  @ParameterizedTest
  @CsvSource({
    "scenario7, optimal, 1",
    "scenario7, zoom-out, 2",
    "scenario-w1, optimal, 1",
    "scenario-w1, zoom-out, 2"
  })
  void kMinEqualsTheRecordedOneInEveryStep(String name, String policy, int column)
      throws IOException {
    Path recorded = Cli.reference("coverage-study/" + name + ".expected.csv");
    assumeTrue(Files.exists(recorded), "no reference data: skipped");
    Cli run =
        Cli.run(
            "run",
            Cli.reference("coverage-study/" + name + ".xml"),
            "--detection",
            "camsim-range",
            "--threshold",
            "0.3",
            "--policy",
            policy,
            "--steps",
            300,
            "--seed",
            0,
            "--headings",
            "as-radians",
            "--out",
            folder);
    assertEquals(0, run.exit(), run.err());
    List<String> expected = column(recorded, column);
    assertEquals(300, expected.size());
    assertEquals(expected, column(folder.resolve("steps.csv"), 2));
  }

  private static List<String> column(Path csv, int column) throws IOException {
    return Files.readAllLines(csv).stream().skip(1).map(row -> row.split(",")[column]).toList();
  }
}
