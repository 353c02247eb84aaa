package org.hificamsim.runs.compare;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.spec.StepOrder;
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

  /** A model with one support vector at 30 m, whose kernel is exactly 0 below 16 m. */
  private static final String FAR =
      """
      {"schema": "hificamsim-model", "version": 1, "name": "far",
       "f": {"type": "svr-rbf", "gamma": 10, "intercept": 1.5,
             "ranges": {"q": {"least": 0, "most": 1}, "d": {"least": 0, "most": 1},
                        "z": {"least": 0, "most": 1}},
             "support": [[0.5, 30, 0.02, WEIGHT]]},
       "g": {"slope": 0.571, "intercept": 0.026}, "threshold": 0.05}
      """;

  @TempDir Path folder;

  @Test
  void dependsOnEverythingThatChangesResults() throws IOException {
    Scenario scenario = scenario();
    DetectionModel model = Catalogue.load().detection("hifi:orb-lin");
    RunKey key = key(scenario, model, 0.1, "zoom-out", 10);
    assertEquals(key, key(scenario(), Catalogue.load().detection("hifi:orb-lin"), 0.1));
    assertNotEquals(key, key(scenario.with(Scenario.ORDER, StepOrder.CAMSIM), model, 0.1));
    assertNotEquals(
        key, key(scenario.with(Scenario.OBJECTIVE, Objective.parse("covered")), model, 0.1));
    List<Obstacle> wall = List.of(new Obstacle.Wall(0, 0, 1, 1, 0));
    assertNotEquals(key, key(scenario.with(Scenario.OBSTACLES, wall), model, 0.1));
    assertNotEquals(key, key(scenario, Catalogue.load().detection("hifi:orb-sr"), 0.1));
    assertNotEquals(key, key(scenario, model, 0.2));
    assertNotEquals(key, key(scenario, model, 0.1, "zoom-in", 10));
    assertNotEquals(key, key(scenario, model, 0.1, "zoom-out", 11));
  }

  @Test
  void dependsOnSensorOfModelFile() throws IOException {
    assertNotEquals(key(scenario(), model("0.0224"), 0.05), key(scenario(), model("0.0360"), 0.05));
  }

  @Test
  void dependsOnModelBeyondReach() throws IOException {
    DetectionModel model = read(FAR.replace("WEIGHT", "-2"));
    DetectionModel other = read(FAR.replace("WEIGHT", "2"));
    ZoomLevel zoom = new ZoomLevel(40, 1, 16, 3, 2 * Math.PI);
    for (double distance = 0; distance < 16; distance += 0.01) {
      assertEquals(
          model.confidence(0.5, distance, 0, zoom), other.confidence(0.5, distance, 0, zoom));
    }
    assertNotEquals(model.confidence(0.5, 30, 0, zoom), other.confidence(0.5, 30, 0, zoom));
    assertNotEquals(key(scenario(), model, 0.05), key(scenario(), other, 0.05));
  }

  @Test
  void namesChangedInput() throws IOException {
    RunKey key = key(scenario(), model("0.0224"), 0.05);
    assertEquals(
        Optional.of("detection 'mine'"), key.changed(key(scenario(), model("0.0360"), 0.05)));
    assertEquals(
        Optional.of("scenario 'one'"),
        key.changed(key(scenario().with(Scenario.ORDER, StepOrder.CAMSIM), model("0.0224"), 0.05)));
    assertEquals(Optional.of("version of 'hificamsim'"), key.changed(RunKey.read("a1b2c3")));
  }

  @Test
  void findsNoChangeIfOnlySettingsDiffer() throws IOException {
    RunKey key = key(scenario(), model("0.0224"), 0.05);
    assertEquals(Optional.empty(), key.changed(RunKey.read(key.text())));
    assertEquals(
        Optional.empty(), key.changed(key(scenario(), model("0.0224"), 0.2, "zoom-in", 9)));
    assertEquals(
        Optional.empty(), key.changed(key(scenario(), read(FAR.replace("WEIGHT", "2")), 0.05)));
  }

  private Scenario scenario() throws IOException {
    Path file = Files.writeString(folder.resolve("one.xml"), SCENARIO);
    return ScenarioReader.read(file, name -> true, warning -> {});
  }

  private DetectionModel model(String sensorWidth) throws IOException {
    return read(MODEL.replace("SENSOR", sensorWidth));
  }

  private DetectionModel read(String model) throws IOException {
    return ModelFiles.read(Files.writeString(folder.resolve("model.json"), model));
  }

  private static RunKey key(Scenario scenario, DetectionModel model, double threshold) {
    return key(scenario, model, threshold, "zoom-out", 10);
  }

  private static RunKey key(
      Scenario scenario, DetectionModel model, double threshold, String policy, int steps) {
    return RunKey.of(new RunPlan(scenario, new Detection(model, threshold), policy, steps, 0, 1));
  }
}
