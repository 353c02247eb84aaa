package org.hificamsim.runs.output;

import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.JsonNodeFactory;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.OpticsSpec;
import org.hificamsim.core.world.World;
import org.hificamsim.hifi.OpticalDetection;
import org.hificamsim.hifi.optics.Optics;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Setting;

/** Writes all settings of plans to result files. */
public final class SettingsFile {
  private SettingsFile() {}

  /** Adds {@code settings.json}, with an object for each plan, to a folder's files. */
  public static void write(OutputFolder folder, List<RunPlan> plans) throws IOException {
    ArrayNode settings = JsonNodeFactory.instance.arrayNode();
    plans.forEach(plan -> settings.add(of(plan)));
    JsonOutput.write(folder, ResultFolder.SETTINGS, settings);
  }

  /** The settings of a plan. */
  static ObjectNode of(RunPlan plan) {
    Scenario scenario = plan.scenario();
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("scenario", scenario.name());
    for (Setting setting : Setting.values()) {
      plan.value(setting).ifPresent(value -> put(json, setting, value));
    }
    putNumbers(json, "zooms", scenario.zooms());
    json.put("cameras", scenario.cameras().size());
    putOptics(json, scenario);
    putLens(json, plan);
    plan.sources()
        .forEach((setting, source) -> json.put(setting.label() + "_from", Spelling.of(source)));
    json.put("score_words", plan.objective().words());
    json.put("score_unit", plan.objective().isShare() ? "share" : plan.objective().unit());
    return json;
  }

  private static void put(ObjectNode json, Setting setting, String value) {
    switch (setting.kind()) {
      case TEXT -> json.put(setting.field(), value);
      case INT, LONG -> json.put(setting.field(), Long.parseLong(value));
      case NUMBER -> json.put(setting.field(), Double.parseDouble(value));
    }
  }

  /** Adds each kind of optics once; nothing if no camera has any. */
  private static void putOptics(ObjectNode json, Scenario scenario) {
    scenario
        .everyCamera()
        .map(CameraSpec::optics)
        .flatMap(Optional::stream)
        .distinct()
        .forEach(optics -> json.withArray("optics").add(of(optics)));
  }

  /** Writes optics with the names of attributes in scenario files. */
  private static ObjectNode of(OpticsSpec optics) {
    ObjectNode json = JsonNodeFactory.instance.objectNode();
    json.put("name", optics.name());
    json.put("law", Spelling.of(optics.law()));
    optics.pixels().ifPresent(pixels -> json.put("pixels", pixels));
    putNumbers(json, "hfov", optics.anglesOfView());
    optics.reach().ifPresent(reach -> json.put("reach", reach));
    putNumbers(json, "pan", optics.pans());
    if (optics.takesTime()) {
      optics.panSpeed().ifPresent(speed -> json.put("pan_speed", speed));
      json.put("zoom_time", optics.zoomTime());
      json.put("moving", Spelling.of(optics.moving()));
    }
    return json;
  }

  /**
   * Adds the lens of the model (Eqs 3.1 and 3.2) in metres: the mount height of all cameras, and a
   * focal length for each zoom. The mount height is that of the scenario, or else the height at
   * which the narrowest radius has the longest focal length. Lenses of single cameras are omitted.
   */
  private static void putLens(ObjectNode json, RunPlan plan) {
    Scenario scenario = plan.scenario();
    OptionalDouble height = scenario.mountHeight();
    List<Double> focalLengths = List.of();
    if (plan.detection().model() instanceof OpticalDetection model
        && scenario.inCoverageDialect()) {
      Optics optics = model.optics();
      focalLengths =
          World.zoomLevels(scenario).stream()
              .filter(zoom -> !zoom.hasLens())
              .map(optics::focalLength)
              .distinct()
              .toList();
      if (height.isEmpty()) {
        double narrowest = scenario.zooms().get(0);
        height = OptionalDouble.of(optics.mountHeight(narrowest, optics.longestFocalLength()));
      }
    }
    json.put("mount_height", height.isPresent() ? (Double) height.getAsDouble() : null);
    putNumbers(json, "focal_lengths", focalLengths);
  }

  private static void putNumbers(ObjectNode json, String name, List<Double> values) {
    ArrayNode array = json.putArray(name);
    values.forEach(array::add);
  }
}
