package org.hificamsim.onnx;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.Settings;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Evaluates the policies trained by python/examples/ppo.py on seeds not used in training. */
class TrainedPoliciesTest {
  private static final Path ROOT = Path.of(System.getProperty("hificamsim.root"));
  private static final Path TRAINED = ROOT.resolve("python/examples/trained");
  private static final int SEED = 100;

  private final Catalogue catalogue = Catalogue.load();
  private final RunExecutor executor = new RunExecutor(catalogue);

  /** Training seeds start at 1,000,000; best-fixed is optimised for the evaluated run. */
  @ParameterizedTest
  @CsvSource({
    "border, ttpf:task=recognise, 1.1, 2.0",
    "car-park, dori-2014:level=identify, 1.02, 1.9",
  })
  void beatsBestFixedAndBandit(String site, String detection, double overFixed, double overBandit) {
    double trained = score(plan(site, detection, "onnx:" + TRAINED.resolve(site + ".onnx"), 300));
    double fixed = score(plan(site, detection, "best-fixed", 300));
    double bandit = score(plan(site, detection, "epsilon-greedy", 300));
    assertTrue(trained >= overFixed * fixed, trained + " and " + fixed);
    assertTrue(trained >= overBandit * bandit, trained + " and " + bandit);
  }

  /** choices.csv was computed by greedy.py, which test_learning.py verifies. */
  @Test
  void choosesSameViewsAsNumPy() throws IOException {
    List<String> expected = Files.readAllLines(TRAINED.resolve("choices.csv"));
    String policy = "onnx:" + TRAINED.resolve("border.onnx");
    List<String> choices = new ArrayList<>();
    StepListener listener =
        (network, coverage) ->
            choices.add(
                IntStream.range(0, network.cameras())
                    .mapToObj(camera -> Integer.toString(network.view(camera)))
                    .collect(Collectors.joining(",")));
    executor.repeat(plan("border", "ttpf:task=recognise", policy, 100), 0, List.of(listener));
    assertEquals(100, expected.size());
    assertEquals(expected, choices);
    assertTrue(expected.stream().distinct().count() > 30, "too few different choices");
  }

  private double score(RunPlan plan) {
    return executor.execute(plan, run -> List.of()).stream()
        .mapToDouble(RunResult::score)
        .average()
        .orElseThrow();
  }

  private RunPlan plan(String site, String detection, String policy, int steps) {
    Path file = ROOT.resolve("scenarios").resolve(site + ".xml");
    Scenario scenario = ScenarioReader.read(file, catalogue.movements()::knows, warning -> {});
    Detection used =
        DetectionSpec.parse(detection, catalogue::detection).detection(Settings.NONE, scenario);
    return new RunPlan(scenario, used, policy, steps, SEED, 5);
  }
}
