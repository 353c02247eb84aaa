package org.hificamsim.runs.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.StepOrder;
import org.hificamsim.hifi.model.ModelFiles;
import org.hificamsim.runs.RunPlan;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

class RunKeyTest {
  private static final String SCENARIO =
      """
      <root><simulation min_x="-9" max_x="9" min_y="-9" max_y="9" mount_height="3">
      <cameras><zoom>2 4 8</zoom>
      <camera name="A" x="0" y="0" heading="0" viewing_angle="360" range="1"/></cameras>
      <objects><object features="1" x="1" y="1" heading="0" speed="1"/></objects>
      </simulation></root>
      """;

  private static final String MODEL =
      """
      {"schema": "hificamsim-model", "version": 1, "name": "mine",
       "f": {"type": "linear", "z": -18.82, "q": -2.0, "d": 0.2, "intercept": 2.47},
       "g": {"slope": 0.571, "intercept": 0.026},
       "optics": {"sensorWidth": SENSOR, "longestFocalLength": 0.085}, "threshold": 0.05}
      """;

  @TempDir Path folder;

  @Test
  void differsWithWhateverTheResultDependsOn() throws IOException {
    Scenario scenario = scenario();
    DetectionModel model = Catalogue.load().detection("hifi:orb-lin");
    String key = key(scenario, model, 0.1, "zoom-out", 10);
    assertEquals(key, key(scenario(), Catalogue.load().detection("hifi:orb-lin"), 0.1));
    assertNotEquals(key, key(scenario.withOrder(StepOrder.CAMSIM), model, 0.1));
    assertNotEquals(key, key(scenario, Catalogue.load().detection("hifi:orb-sr"), 0.1));
    assertNotEquals(key, key(scenario, model, 0.2));
    assertNotEquals(key, key(scenario, model, 0.1, "zoom-in", 10));
    assertNotEquals(key, key(scenario, model, 0.1, "zoom-out", 11));
  }

  @Test
  void differsWithTheSensorOfAModelFileWhereTheMountHeightMakesItCount() throws IOException {
    assertNotEquals(key(scenario(), model("0.0224"), 0.05), key(scenario(), model("0.0360"), 0.05));
  }

  private Scenario scenario() throws IOException {
    Path file = Files.writeString(folder.resolve("one.xml"), SCENARIO);
    return ScenarioReader.read(file, name -> true, warning -> {});
  }

  private DetectionModel model(String sensorWidth) throws IOException {
    Path file = folder.resolve("model.json");
    return ModelFiles.read(Files.writeString(file, MODEL.replace("SENSOR", sensorWidth)));
  }

  private static String key(Scenario scenario, DetectionModel model, double threshold) {
    return key(scenario, model, threshold, "zoom-out", 10);
  }

  private static String key(
      Scenario scenario, DetectionModel model, double threshold, String policy, int steps) {
    return RunKey.of(new RunPlan(scenario, new Detection(model, threshold), policy, steps, 0, 1));
  }
}
