package org.hificamsim.spark;

import java.io.IOException;
import java.io.Serializable;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.util.EnumMap;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.scenario.ScenarioWriter;
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
      throw new InputException(
          "scenario '%s' with detection '%s': %s is another on an executor than here, expected the same version and jars"
              .formatted(scenario, detection.name(), input));
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
