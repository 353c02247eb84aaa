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
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.model.ModelFiles;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.compare.RunKey;

/**
 * A plan as text, for machines that share no files with this one.
 *
 * @param scenario its name
 * @param xml the scenario's content
 * @param own the settings that the plan itself keeps
 * @param key of the plan's results: a machine that comes to another one would compute another plan
 */
record PortablePlan(
    String scenario,
    String xml,
    PortableDetection detection,
    EnumMap<Setting, String> own,
    String key)
    implements Serializable {
  /**
   * A detection model and its threshold as text.
   *
   * @param name in result files
   * @param model the content of a model file, or the name in the catalogue of a model that is code
   * @param isFile which of the two it is
   * @param rule how a value becomes a detection
   */
  record PortableDetection(String name, String model, boolean isFile, double threshold, String rule)
      implements Serializable {
    static PortableDetection of(Detection detection) {
      boolean isFile = detection.model() instanceof HiFiDetection;
      String model =
          detection.model() instanceof HiFiDetection fitted
              ? new String(ModelFiles.bytes(fitted), StandardCharsets.UTF_8)
              : detection.model().name();
      return new PortableDetection(
          detection.name(), model, isFile, detection.threshold(), detection.rule().text());
    }

    /** The detection with the same values. */
    Detection detection(Catalogue catalogue) {
      DetectionModel made =
          isFile
              ? ModelFiles.parse(name, model.getBytes(StandardCharsets.UTF_8))
              : catalogue.detections().create(model);
      DetectionRule decides = DetectionRule.parse(rule);
      return decides.certain()
          ? new Detection(name, made, threshold)
          : Detection.by(decides, name, made);
    }
  }

  /**
   * The plan as text.
   *
   * @throws InputException when the text does not give the same plan
   */
  static PortablePlan of(RunPlan plan, Catalogue catalogue) {
    PortablePlan portable =
        new PortablePlan(
            plan.scenario().name(),
            ScenarioWriter.write(plan.scenario()),
            PortableDetection.of(plan.detection()),
            new EnumMap<>(plan.own()),
            RunKey.of(plan).text());
    portable.plan(catalogue);
    return portable;
  }

  /**
   * The plan with the same results.
   *
   * @throws InputException when models, jars or the version here are others than where it was made
   */
  RunPlan plan(Catalogue catalogue) {
    RunPlan plan = new RunPlan(readScenario(catalogue), detection.detection(catalogue), own);
    RunKey there = RunKey.of(plan);
    if (!there.text().equals(key)) {
      String input = there.changed(RunKey.read(key)).orElse("a user's jar");
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
