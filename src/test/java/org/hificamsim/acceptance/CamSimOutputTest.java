package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Reference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvFileSource;

/** Tests that {@code camsim} writes the same bytes as CamSim (docs/evidence.md). */
class CamSimOutputTest {
  private static final String OURS = "own-camsim/";

  @TempDir Path folder;

  @ParameterizedTest
  @CsvFileSource(resources = "/reference/own-camsim/index.csv", useHeadersInDisplayName = true)
  void ownScenariosEqualOutputOfCamSim(String scenario, String options, String output)
      throws IOException {
    assertOutput(OURS + output, options, OURS + scenario);
  }

  @Test
  void indexListsAllOwnScenarios() throws IOException {
    List<String> listed = new ArrayList<>();
    for (String[] row : Reference.rows(OURS + "index.csv")) {
      listed.add(row[0]);
    }
    assertEquals(26, listed.size());
    assertEquals(
        listed,
        Reference.scenarios(OURS).stream().map(file -> file.getFileName().toString()).toList());
  }

  @Test
  void reproducesOutputsOfCamSimsScenarios() throws IOException {
    int compared = 0;
    for (String[] row : Reference.rows("camsim/outputs/index.csv")) {
      if (row[0].startsWith("SASO-scenario") || row[0].startsWith("custom-")) {
        assertOutput("camsim/outputs/" + row[0], row[2], "camsim/scenarios/" + row[1]);
        compared++;
      }
    }
    assertEquals(17, compared);
  }

  @Test
  void scenariosOfCamSimAreValidAndRun() throws IOException {
    List<Path> scenarios = Reference.scenarios("camsim/scenarios");
    assertEquals(49, scenarios.size());
    for (Path file : scenarios) {
      Cli.assertValidAndRuns(file, folder);
      assertEquals(1001, lines("-t 1000", file).size());
    }
  }

  private void assertOutput(String recorded, String options, String scenario) throws IOException {
    List<String> expected = Files.readAllLines(Reference.file(recorded));
    assertTrue(expected.size() > 120, recorded);
    assertEquals(expected, lines(options, Reference.file(scenario)), recorded);
  }

  private List<String> lines(String options, Path scenario) throws IOException {
    Path output = folder.resolve("o.csv");
    List<Object> words = new ArrayList<>(List.of("camsim"));
    words.addAll(List.of(options.split(" ")));
    words.addAll(List.of("-o", output, scenario));
    Cli run = Cli.run(words.toArray());
    assertEquals(0, run.exit(), run.err());
    return Files.readAllLines(output);
  }
}
