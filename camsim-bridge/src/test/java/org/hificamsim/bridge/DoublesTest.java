package org.hificamsim.bridge;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.Reference;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Compares the doubles with files that CamSim itself has written. */
class DoublesTest {
  @TempDir Path folder;

  @Test
  void doublesReproduceNumbersOfCamSim() throws IOException {
    assertOutput("SASO/scenario6", "SASO-scenario6__Active__c0__s0__t1000", 1000);
    assertOutput("ICDSC2012/scenario_5", "ICDSC2012-scenario_5__Active__c0__s0__t400", 400);
    assertOutput("scenario1_active", "scenario1_active__Active__c0__s0__t200", 200);
  }

  private void assertOutput(String scenario, String output, int steps) throws IOException {
    Path recorded = Reference.file("camsim/outputs/" + output + ".csv");
    CamSimRun run =
        CamSimRun.of(
            folder,
            CamSimRun.WITHOUT_AGENT,
            Reference.file("camsim/scenarios/" + scenario + ".xml"),
            steps);
    List<String> expected = Files.readString(recorded).lines().skip(1).toList();
    List<String> rows = run.rows("output.csv");
    assertEquals(steps, rows.size());
    for (int step = 0; step < steps; step++) {
      assertRow(expected.get(step), rows.get(step));
    }
  }

  private static void assertRow(String expected, String row) {
    String[] numbers = row.split(";");
    String[] recorded = expected.split(";");
    for (int i = 0; i < recorded.length; i++) {
      double value = Double.parseDouble(recorded[i]);
      assertEquals(value, Double.parseDouble(numbers[i]), 1e-9 * Math.max(1, value), row);
    }
  }
}
