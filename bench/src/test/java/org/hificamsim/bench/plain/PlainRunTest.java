package org.hificamsim.bench.plain;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.output.Detail;
import org.hificamsim.runs.output.RunFolder;
import org.hificamsim.runs.output.TableFormat;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Compares the table of a plain run with that of {@code run}, without exploring. */
class PlainRunTest {
  private static final Path FILE =
      Path.of(System.getProperty("hificamsim.root"), "bench", "study-10x6.xml");
  private static final int STEPS = 2000;

  @TempDir Path folder;

  @ParameterizedTest
  @CsvSource({
    "zoom-out, zoom-out",
    "epsilon-greedy, epsilon-greedy:epsilon=0",
    "sarsa, sarsa:epsilon=0"
  })
  void tableHasSameBytesAsThatOfEngine(String plain, String policy) throws IOException {
    Path table = folder.resolve("plain.csv");
    PlainRun.main(
        new String[] {FILE.toString(), "camsim-range@0.3", plain, "0", "" + STEPS, "" + table});
    assertEquals(Files.readString(engineTable(policy)), Files.readString(table));
  }

  private Path engineTable(String policy) throws IOException {
    Catalogue catalogue = Catalogue.load();
    Scenario scenario =
        ScenarioReader.read(FILE, catalogue.movements().names()::contains, warning -> {});
    Detection detection = new Detection(catalogue.detection("camsim-range"), 0.3);
    RunPlan plan = new RunPlan(scenario, detection, policy, STEPS, 0, 1);
    try (RunFolder output =
        new RunFolder(new OutputFolder(folder), detection, Detail.STEPS, TableFormat.CSV)) {
      var results = new RunExecutor(catalogue).execute(plan, run -> List.of(output.listener(run)));
      output.finish(plan, results);
      output.commit();
    }
    return folder.resolve("steps.csv");
  }
}
