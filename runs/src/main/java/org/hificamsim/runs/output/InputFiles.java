package org.hificamsim.runs.output;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.model.ModelFiles;
import org.hificamsim.runs.RunPlan;

/**
 * Writes what plans were run on to the folder of their results: each scenario as it was run,
 * overrides and all, each fitted detection model, and what a policy decides by. They are files that
 * {@code run} and {@code compare} take.
 */
public final class InputFiles {
  private static final String SCENARIO = "scenario-";
  private static final String DETECTION = "detection-";
  private static final String POLICY = "policy-";

  private InputFiles() {}

  /** Whether a file is one of these. */
  static boolean isInput(String name) {
    return name.startsWith(SCENARIO) || name.startsWith(DETECTION) || name.startsWith(POLICY);
  }

  /** Adds them to a folder's files. */
  public static void write(OutputFolder folder, List<RunPlan> plans) throws IOException {
    Map<String, byte[]> files = new LinkedHashMap<>();
    Map<String, byte[]> models = new LinkedHashMap<>();
    distinct(plans, plan -> plan.detection().model()).forEach(one -> add(models, one));
    distinct(plans, plan -> asRun(plan, plans, models)).forEach(one -> add(files, one));
    files.putAll(models);
    PolicyFiles policies = new PolicyFiles();
    plans.stream()
        .flatMap(plan -> policies.of(plan.policy()).stream())
        .distinct()
        .forEach(file -> add(files, file));
    for (Map.Entry<String, byte[]> file : files.entrySet()) {
      folder.write(file.getKey(), file.getValue());
    }
  }

  /** Without hashing, which is slow the first time for records of records of records. */
  private static <T> List<T> distinct(List<RunPlan> plans, Function<RunPlan, T> part) {
    List<T> distinct = new ArrayList<>();
    for (RunPlan plan : plans) {
      T one = part.apply(plan);
      if (!distinct.contains(one)) {
        distinct.add(one);
      }
    }
    return distinct;
  }

  private static void add(Map<String, byte[]> files, Scenario scenario) {
    byte[] content =
        ScenarioWriter.write(scenario.withoutFloorplan()).getBytes(StandardCharsets.UTF_8);
    files.put(free(files, SCENARIO + scenario.name(), ".xml"), content);
  }

  /**
   * A scenario that names a detection names the one that it was run with, a model file being the
   * copy in the folder; none where there were several.
   */
  private static Scenario asRun(RunPlan plan, List<RunPlan> plans, Map<String, byte[]> models) {
    Scenario scenario = plan.scenario();
    if (scenario.find(Scenario.DETECTION).isEmpty()) {
      return scenario;
    }
    boolean several =
        plans.stream()
            .filter(other -> other.scenario().equals(scenario))
            .anyMatch(other -> !other.detection().name().equals(plan.detection().name()));
    return several
        ? scenario.without(Scenario.DETECTION)
        : scenario
            .without(Scenario.THRESHOLD)
            .without(Scenario.DETECT)
            .with(Scenario.DETECTION, named(plan.detection(), models));
  }

  private static String named(Detection detection, Map<String, byte[]> models) {
    return model(detection.model(), models) + "@" + rule(detection);
  }

  private static String model(DetectionModel model, Map<String, byte[]> models) {
    return model instanceof HiFiDetection fitted
        ? models.entrySet().stream()
            .filter(file -> Arrays.equals(file.getValue(), ModelFiles.bytes(fitted)))
            .findFirst()
            .map(Map.Entry::getKey)
            .orElseThrow()
        : model.name();
  }

  /** As it follows the name of a detection. */
  private static String rule(Detection detection) {
    return detection.certain()
        ? String.valueOf(detection.threshold())
        : detection.rule().text().replace(',', ';');
  }

  /** A model that is code has no file; its name, and the version that has it, are all there is. */
  private static void add(Map<String, byte[]> files, DetectionModel model) {
    if (model instanceof HiFiDetection fitted) {
      String name = DETECTION + fitted.name().replaceAll("[^\\w.+-]", "-");
      files.put(free(files, name, ".json"), ModelFiles.bytes(fitted));
    }
  }

  private static void add(Map<String, byte[]> files, Path policy) {
    String name = policy.getFileName().toString();
    int dot = name.lastIndexOf('.') < 0 ? name.length() : name.lastIndexOf('.');
    String free = free(files, POLICY + name.substring(0, dot), name.substring(dot));
    files.put(free, PolicyFiles.content(policy));
  }

  /** The name, with a number where another content has it: variants may share a name. */
  private static String free(Map<String, byte[]> files, String name, String ending) {
    String free = name + ending;
    for (int i = 2; files.containsKey(free); i++) {
      free = name + "-" + i + ending;
    }
    return free;
  }
}
