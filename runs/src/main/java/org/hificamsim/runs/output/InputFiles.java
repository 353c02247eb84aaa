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
import org.hificamsim.hifi.FittedDetection;
import org.hificamsim.hifi.model.ModelFiles;
import org.hificamsim.runs.RunPlan;

/**
 * Writes the inputs of plans to the folder of their results: each scenario as it was run, with all
 * overrides, each fitted detection model, and the files that a policy reads. {@code run} and {@code
 * compare} can read them again.
 */
public final class InputFiles {
  private static final String SCENARIO = "scenario-";
  private static final String DETECTION = "detection-";
  private static final String POLICY = "policy-";

  private InputFiles() {}

  /** Whether a file in a folder of results is an input. */
  static boolean isInput(String name) {
    return name.startsWith(SCENARIO) || name.startsWith(DETECTION) || name.startsWith(POLICY);
  }

  /** Adds the inputs to a folder's files. */
  public static void write(OutputFolder folder, List<RunPlan> plans) throws IOException {
    Map<String, byte[]> files = new LinkedHashMap<>();
    Map<String, byte[]> models = new LinkedHashMap<>();
    distinct(plans, plan -> plan.detection().model()).forEach(model -> add(models, model));
    distinct(plans, plan -> asRun(plan, plans, models)).forEach(scenario -> add(files, scenario));
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

  /** The distinct parts of plans, compared one by one: hashing nested records would be slower. */
  private static <T> List<T> distinct(List<RunPlan> plans, Function<RunPlan, T> part) {
    List<T> distinct = new ArrayList<>();
    for (RunPlan plan : plans) {
      T value = part.apply(plan);
      if (!distinct.contains(value)) {
        distinct.add(value);
      }
    }
    return distinct;
  }

  private static void add(Map<String, byte[]> files, Scenario scenario) {
    byte[] content =
        ScenarioWriter.write(scenario.withoutFloorplan()).getBytes(StandardCharsets.UTF_8);
    files.put(freeName(files, SCENARIO + scenario.name(), ".xml"), content);
  }

  /**
   * The scenario as it was run. A scenario that names a detection gets the one that it was run
   * with, by the copy in the folder if that is a file; if it was run with several, it names none.
   */
  private static Scenario asRun(RunPlan plan, List<RunPlan> plans, Map<String, byte[]> models) {
    Scenario scenario = plan.scenario();
    if (scenario.find(Scenario.DETECTION).isEmpty()) {
      return scenario;
    }
    boolean hasSeveral =
        plans.stream()
            .filter(other -> other.scenario().equals(scenario))
            .anyMatch(other -> !other.detection().name().equals(plan.detection().name()));
    return hasSeveral
        ? scenario.without(Scenario.DETECTION)
        : scenario
            .without(Scenario.THRESHOLD)
            .without(Scenario.DETECT)
            .with(Scenario.DETECTION, name(plan.detection(), models));
  }

  private static String name(Detection detection, Map<String, byte[]> models) {
    return name(detection.model(), models) + "@" + rule(detection);
  }

  private static String name(DetectionModel model, Map<String, byte[]> models) {
    return model instanceof FittedDetection fitted
        ? models.entrySet().stream()
            .filter(file -> Arrays.equals(file.getValue(), ModelFiles.bytes(fitted)))
            .findFirst()
            .map(Map.Entry::getKey)
            .orElseThrow()
        : model.name();
  }

  /** The rule or threshold as it follows {@code @} in the name of a detection. */
  private static String rule(Detection detection) {
    return detection.certain()
        ? String.valueOf(detection.threshold())
        : detection.rule().text().replace(',', ';');
  }

  /** Adds the file of a fitted model. A model that is code has no file, only its name. */
  private static void add(Map<String, byte[]> files, DetectionModel model) {
    if (model instanceof FittedDetection fitted) {
      String name = DETECTION + fitted.name().replaceAll("[^\\w.+-]", "-");
      files.put(freeName(files, name, ".json"), ModelFiles.bytes(fitted));
    }
  }

  private static void add(Map<String, byte[]> files, Path policy) {
    String name = policy.getFileName().toString();
    int dot = name.lastIndexOf('.') < 0 ? name.length() : name.lastIndexOf('.');
    String copy = freeName(files, POLICY + name.substring(0, dot), name.substring(dot));
    files.put(copy, PolicyFiles.content(policy));
  }

  /** Returns a name that no other file has, with a number if necessary. */
  private static String freeName(Map<String, byte[]> files, String name, String ending) {
    String free = name + ending;
    for (int i = 2; files.containsKey(free); i++) {
      free = name + "-" + i + ending;
    }
    return free;
  }
}
