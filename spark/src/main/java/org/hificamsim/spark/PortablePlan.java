package org.hificamsim.spark;

import java.io.IOException;
import java.io.Serializable;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.util.EnumMap;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.hifi.FittedDetection;
import org.hificamsim.hifi.model.ModelFiles;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.compare.RunKey;

/**
 * A plan as text, for machines that share no files with this one.
 *
 * @param scenario the name of the scenario
 * @param xml the content of its file
 * @param keptValues the values of the settings that the plan keeps itself
 * @param key the key of the results; a machine that gets another key would compute another plan
 */
record PortablePlan(
    String scenario,
    String xml,
    PortableDetection detection,
    EnumMap<Setting, String> keptValues,
    String key)
    implements Serializable {
  /**
   * A detection model and its threshold as text.
   *
   * @param name the name in result files
   * @param model the content of a model file, or the name in the catalogue of a model that is code
   * @param isFile whether the model is the content of a file
   * @param rule the rule by which a confidence becomes a detection
   */
  record PortableDetection(String name, String model, boolean isFile, double threshold, String rule)
      implements Serializable {
    static PortableDetection of(Detection detection) {
      boolean isFile = detection.model() instanceof FittedDetection;
      String model =
          detection.model() instanceof FittedDetection fitted
              ? new String(ModelFiles.bytes(fitted), StandardCharsets.UTF_8)
              : detection.model().name();
      return new PortableDetection(
          detection.name(), model, isFile, detection.threshold(), detection.rule().text());
    }

    /** Restores the detection. */
    Detection detection(Catalogue catalogue) {
      DetectionModel restored =
          isFile
              ? ModelFiles.parse(name, model.getBytes(StandardCharsets.UTF_8))
              : catalogue.detections().create(model);
      DetectionRule restoredRule = DetectionRule.parse(rule);
      return restoredRule.certain()
          ? new Detection(name, restored, threshold)
          : Detection.by(restoredRule, name, restored);
    }
  }

  /**
   * Writes a plan as text.
   *
   * @throws InputException when the text does not give the same plan
   */
  static PortablePlan of(RunPlan plan, Catalogue catalogue) {
    PortablePlan portable =
        new PortablePlan(
            plan.scenario().name(),
            ScenarioWriter.write(plan.scenario()),
            PortableDetection.of(plan.detection()),
            new EnumMap<>(plan.keptValues()),
            RunKey.of(plan).text());
    portable.plan(catalogue);
    return portable;
  }

  /**
   * Restores the plan, on the machine that computes it.
   *
   * @throws InputException when models, jars or the version differ from those of the driver
   */
  RunPlan plan(Catalogue catalogue) {
    RunPlan plan = new RunPlan(readScenario(catalogue), detection.detection(catalogue), keptValues);
    RunKey keyHere = RunKey.of(plan);
    if (!keyHere.text().equals(key)) {
      String input = keyHere.changed(RunKey.read(key)).orElse("a user's jar");
      throw InputException.of(
          "scenario '%s' with detection '%s': %s is another on an executor than here,"
              + " expected the same version and jars",
          scenario, detection.name(), input);
    }
    return plan;
  }

  private Scenario readScenario(Catalogue catalogue) {
    try (TemporaryFile file = new TemporaryFile(scenario + ".xml")) {
      Files.writeString(file.path(), xml);
      return ScenarioReader.read(
          file.path(), catalogue.movements().names()::contains, warning -> {});
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
