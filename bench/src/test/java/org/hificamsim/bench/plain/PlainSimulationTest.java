package org.hificamsim.bench.plain;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertIterableEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.function.IntFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioReader;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Compares the plain objects with the engine. */
class PlainSimulationTest {
  private static final int STEPS = 1000;
  private static final int SEEDS = 20;

  private record Measured(int kMin, long detections) {}

  private final Catalogue catalogue = Catalogue.load();
  private final Scenario scenario =
      ScenarioReader.read(
          Path.of(System.getProperty("hificamsim.root"), "bench", "cluster-8.xml"),
          catalogue.movements().names()::contains,
          warning -> {});

  @ParameterizedTest
  @ValueSource(strings = {"zoom-out", "epsilon-greedy", "sarsa"})
  void everyStepEqualsEngineWithoutRandomness(String policy) {
    String exploiting = policy.equals("zoom-out") ? policy : policy + ":epsilon=0";
    List<Measured> expected = engine(exploiting, 3);
    assertEquals(STEPS, expected.size());
    assertIterableEquals(expected, plain(policy, 0, 3));
    assertTrue(expected.stream().distinct().count() > 5, "not always the same");
  }

  @Test
  void learningWithoutExploringDiffersFromZoomingOut() {
    assertNotEquals(plain("sarsa", 0, 3), plain("zoom-out", 0, 3));
  }

  @ParameterizedTest
  @ValueSource(strings = {"epsilon-greedy", "sarsa"})
  void exploringPolicyDetectsAboutAsManyTargetsAsInEngine(String policy) {
    double expected = mean(seed -> engine(policy, seed));
    assertEquals(expected, mean(seed -> plain(policy, 0.1, seed)), 0.03 * expected);
  }

  private List<Measured> plain(String policy, double epsilon, long seed) {
    PlainSimulation simulation =
        new PlainSimulation(scenario, "hifi:orb-lin", policy, epsilon, seed);
    return Stream.generate(() -> new Measured(simulation.step(), simulation.detections()))
        .limit(STEPS)
        .toList();
  }

  private List<Measured> engine(String policy, long seed) {
    List<Measured> series = new ArrayList<>();
    new Simulation(
            new World(scenario, catalogue.movements(), seed),
            Detection.of(catalogue.detection("hifi:orb-lin")),
            catalogue.policies().create(policy),
            seed,
            List.of(
                (network, coverage) ->
                    series.add(new Measured(coverage.kMin(), coverage.detections()))))
        .run(STEPS);
    return series;
  }

  private static double mean(IntFunction<List<Measured>> run) {
    return IntStream.range(0, SEEDS)
        .mapToObj(run)
        .flatMap(List::stream)
        .mapToLong(Measured::detections)
        .average()
        .orElseThrow();
  }
}
