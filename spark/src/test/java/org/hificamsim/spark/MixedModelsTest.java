package org.hificamsim.spark;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
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
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Comparison;
import org.hificamsim.runs.compare.EngineSettings;
import org.hificamsim.runs.compare.Journal;
import org.hificamsim.runs.compare.JournalledEngine;
import org.hificamsim.runs.compare.ReferencePolicies;
import org.hificamsim.runs.compare.RunEngine;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests detection models that share a name, on a Spark master. */
class MixedModelsTest {
  private static final Catalogue CATALOGUE = Catalogue.load();
  private static final Path SCENARIO =
      Path.of(System.getProperty("hificamsim.root", "."), "scenarios", "cluster-random.xml");

  private static final String MODEL =
      """
      {"schema": "hificamsim-model", "version": 1, "name": "mine",
       "f": {"type": "linear", "z": -18.82, "q": -2.0, "d": 0.2, "intercept": 2.47},
       "g": {"slope": 0.571, "intercept": INTERCEPT}, "threshold": 0.05}
      """;

  /** Detects nothing, and has the name of a model that detects everything. */
  private record Blind() implements DetectionModel {
    @Override
    public String name() {
      return "geometric";
    }

    @Override
    public double confidence(double size, double distance, double offAxis, ZoomLevel zoom) {
      return 0;
    }
  }

  @TempDir Path folder;

  @BeforeAll
  static void requireSpark() {
    SparkHome.require();
  }

  @Test
  void rejectsResumeWithChangedModel() throws IOException {
    RunPlan plan = plan(model("0.026"));
    try (OutputFolder out = new OutputFolder(folder.resolve("out"))) {
      compare(CATALOGUE, plan, out); // and ends before its tables are written
      Path journal = out.path().resolve(Journal.COMPARISON_FILE);
      byte[] finished = Files.readAllBytes(journal);
      InputException fault =
          assertThrows(InputException.class, () -> compare(CATALOGUE, plan(model("0.2")), out));
      assertTrue(
          fault.getMessage().contains("has runs of another detection 'mine'"), fault.getMessage());
      assertArrayEquals(finished, Files.readAllBytes(journal));
      assertEquals(2, compare(CATALOGUE, plan, out).size(), "with the optimum");
    }
  }

  @Test
  void rejectsModelThatDiffersOnExecutor() throws IOException {
    Registry<DetectionModel> here = new Registry<>("detection");
    here.register("geometric", "blind", Blind::new);
    Catalogue changed =
        new Catalogue(
            here,
            CATALOGUE.policies(),
            CATALOGUE.movements(),
            CATALOGUE.listeners(),
            CATALOGUE.networks());
    try (OutputFolder out = new OutputFolder(folder.resolve("out"))) {
      InputException fault =
          assertThrows(InputException.class, () -> compare(changed, plan(new Blind()), out));
      assertTrue(
          fault.getMessage().contains("detection 'geometric' is another on an executor than here"),
          fault.getMessage());
    }
  }

  private static List<CaseResult> compare(Catalogue catalogue, RunPlan plan, OutputFolder folder)
      throws IOException {
    SparkEngine engine = new SparkEngine();
    engine.configure(new EngineSettings(catalogue, 1, Optional.of("local[2]")));
    try (Journal journal = Journal.open(folder, Journal.COMPARISON_FILE, true)) {
      RunEngine journalled = new JournalledEngine(engine, journal, () -> {});
      return Comparison.run(List.of(plan), ReferencePolicies.OPTIMUM, journalled);
    }
  }

  private DetectionModel model(String intercept) throws IOException {
    Path file = folder.resolve("mine.json");
    Files.writeString(file, MODEL.replace("INTERCEPT", intercept));
    return CATALOGUE.detection(file.toString());
  }

  private static RunPlan plan(DetectionModel model) {
    return new RunPlan(
        ScenarioReader.read(SCENARIO, CATALOGUE.movements().names()::contains, warning -> {}),
        new Detection(model, 0.05),
        "zoom-out",
        20,
        7,
        2);
  }
}
