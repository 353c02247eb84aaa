package org.hificamsim.runs.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assertions.fail;

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

class ComparisonTest {
  private static final Catalogue CATALOGUE = Catalogue.load();

  @TempDir Path folder;

  /** Without the lock, a second comparison could use a journal that the first one then deletes. */
  @Test
  void locksFolderUntilJournalIsDeleted() throws IOException {
    Path file = folder.resolve(Journal.COMPARISON_FILE);
    try (OutputFolder output = new OutputFolder(folder);
        Journal journal = Journal.open(output, Journal.COMPARISON_FILE, false)) {
      List<CaseResult> results = compare(journal, () -> {});
      assertEquals(2, results.size(), "the plan and its optimum");
      assertTrue(Files.exists(file));
      assertIsLocked();
      journal.finish();
      assertFalse(Files.exists(file));
      assertIsLocked();
    }
    new OutputFolder(folder).close();
  }

  /** A comparison whose files could not be written is not computed again. */
  @Test
  void reusesRunsInJournal() throws IOException {
    try (OutputFolder output = new OutputFolder(folder)) {
      try (Journal journal = Journal.open(output, Journal.COMPARISON_FILE, false)) {
        compare(journal, () -> {});
      }
      assertEquals(2, Files.readAllLines(folder.resolve(Journal.COMPARISON_FILE)).size());
      try (Journal journal = Journal.open(output, Journal.COMPARISON_FILE, true)) {
        compare(journal, () -> fail("computed again"));
        journal.finish();
      }
    }
    assertFalse(Files.exists(folder.resolve(Journal.COMPARISON_FILE)));
  }

  private void assertIsLocked() {
    assertThrows(InputException.class, () -> new OutputFolder(folder));
  }

  private static List<CaseResult> compare(Journal journal, RunProgress progress)
      throws IOException {
    RunEngine engine = RunEngine.registry().create("local");
    engine.configure(new EngineSettings(CATALOGUE, 1, Optional.empty()));
    return Comparison.run(
        List.of(plan()),
        ReferencePolicies.OPTIMUM,
        new JournalledEngine(engine, journal, progress));
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
