package org.hificamsim.runs.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.runs.RunPlan;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class ComparisonRunTest {
  private static final Catalogue CATALOGUE = Catalogue.load();

  @TempDir Path folder;

  /** Otherwise a second one could begin on a journal that the first one then deletes. */
  @Test
  void theFolderIsHeldUntilTheJournalIsGone() throws IOException {
    Path journal = folder.resolve(Journal.NAME);
    try (OutputFolder output = new OutputFolder(folder)) {
      List<CaseResult> results =
          comparison(false, () -> assertTrue(Files.exists(journal)))
              .executeWithoutTables(
                  List.of(plan()),
                  output,
                  (files, cases) -> {
                    assertTrue(Files.exists(journal));
                    assertHeld();
                  });
      assertEquals(2, results.size(), "the plan and its optimum");
      assertFalse(Files.exists(journal));
      assertHeld();
    }
    new OutputFolder(folder).close();
  }

  /** So that what the page could not hold need not be computed again. */
  @Test
  void allRunsAreInTheJournalUntilTheEndingIsWritten() throws IOException {
    try (OutputFolder output = new OutputFolder(folder)) {
      ComparisonRun failing =
          comparison(
              false,
              () -> {
                throw new IOException("no space left");
              });
      assertThrows(
          IOException.class,
          () -> failing.executeWithoutTables(List.of(plan()), output, (files, cases) -> {}));
      assertEquals(2, Files.readAllLines(folder.resolve(Journal.NAME)).size());
      comparison(true, () -> {}).executeWithoutTables(List.of(plan()), output, (files, all) -> {});
    }
    assertFalse(Files.exists(folder.resolve(Journal.NAME)));
  }

  private void assertHeld() {
    assertThrows(InputException.class, () -> new OutputFolder(folder));
  }

  private static ComparisonRun comparison(boolean resume, ComparisonRun.Ending ending) {
    RunEngine engine = Engines.registry().create("local");
    engine.configure(new EngineSettings(CATALOGUE, 1, Optional.empty()));
    return new ComparisonRun(new Comparison(engine, () -> {}), Yardsticks.OPTIMUM, resume, ending);
  }

  private static RunPlan plan() {
    Path scenarios = Path.of(System.getProperty("hificamsim.root", ".")).resolve("scenarios");
    Scenario ring =
        ScenarioReader.read(
            scenarios.resolve("ring-random.xml"),
            CATALOGUE.movements().names()::contains,
            warning -> {});
    DetectionModel model = CATALOGUE.detection("camsim-range");
    return new RunPlan(ring, new Detection(model, model.defaultThreshold()), "zoom-out", 3, 0, 1);
  }
}
