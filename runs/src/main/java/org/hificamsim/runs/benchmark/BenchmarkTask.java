package org.hificamsim.runs.benchmark;

import java.nio.charset.StandardCharsets;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.LongStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.channel.ChannelModel;
import org.hificamsim.core.file.Sha256;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.ScenarioWriter;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.generate.SiteLayout;

/**
 * A frozen task as its file declares it, with the scale of its scores. A changed task is a new one,
 * with the next version in its name.
 *
 * @param scenario the file of the site, next to the file of the tasks
 * @param steps the number of steps of an episode
 * @param unmapped the obstacles that the cameras' map lacks, by their index in the scenario
 * @param hash the hash of the whole task: see {@link #digest}
 * @param zoomOut for each testing episode the mean score of a step under {@code zoom-out}, which is
 *     0 on the scale
 * @param best for each testing episode the mean score of a step under the optimum, or under a bound
 *     on it if it is not proven, which is 1 on the scale
 * @param proven for each testing episode whether the optimum is proven in every step
 */
public record BenchmarkTask(
    String scenario,
    String detection,
    String objective,
    int steps,
    String channel,
    List<Integer> unmapped,
    SiteLayout layout,
    String hash,
    List<Double> zoomOut,
    List<Double> best,
    List<Boolean> proven) {
  /** The number of seeds for training, which begin at 0; other seeds are reduced modulo it. */
  public static final int TRAINING = 1_000_000;

  /** The seeds of the testing episodes. */
  public static final List<Long> TESTING =
      LongStream.rangeClosed(TRAINING + 1, TRAINING + 10).boxed().toList();

  /** The site as it is drawn for a seed, with the settings of the task. */
  Scenario draw(Scenario site, long seed) {
    boolean isTesting = TESTING.contains(seed);
    return draw(site, isTesting ? seed : Math.floorMod(seed, TRAINING), isTesting);
  }

  /** The site as it is drawn for a seed that is neither for training nor for testing. */
  Scenario drawFresh(Scenario site, long seed) {
    return draw(site, seed, true);
  }

  private Scenario draw(Scenario site, long seed, boolean isTesting) {
    Scenario drawn =
        layout
            .draw(site, seed, isTesting)
            .with(Scenario.DETECTION, detection)
            .with(Scenario.OBJECTIVE, Objective.parse(objective))
            .with(Scenario.CHANNEL, ChannelModel.parse(channel))
            .with(Scenario.STEPS, steps);
    List<Obstacle> obstacles = drawn.obstacles();
    List<Obstacle> mapped =
        IntStream.range(0, obstacles.size())
            .filter(i -> !unmapped.contains(i))
            .mapToObj(obstacles::get)
            .toList();
    return unmapped.isEmpty() ? drawn : drawn.with(Scenario.MAP, mapped);
  }

  RunPlan plan(Catalogue catalogue, Scenario drawn, String policy, long seed) {
    DetectionSpec spec = DetectionSpec.parse(detection, catalogue::detection);
    return new RunPlan(drawn, spec.detection(Settings.NONE, drawn), policy, steps, seed, 1);
  }

  /**
   * The hash of the declaration, of the layouts of all testing seeds and of the first ten training
   * seeds, and of the scale.
   */
  public String digest(Scenario site) {
    LongStream seeds =
        LongStream.concat(LongStream.range(0, 10), TESTING.stream().mapToLong(seed -> seed));
    String layouts =
        seeds
            .mapToObj(seed -> draw(site, seed))
            .map(drawn -> ScenarioWriter.write(drawn) + drawn.find(Scenario.MAP))
            .collect(Collectors.joining("\n"));
    List<Object> declared =
        List.of(
            scenario, detection, objective, steps, channel, unmapped, layout, zoomOut, best,
            proven);
    return Sha256.of((declared + "\n" + layouts).getBytes(StandardCharsets.UTF_8));
  }

  /** Normalises the score of an episode without a scale, by the mean scale of testing episodes. */
  double scaled(double score) {
    return (score - mean(zoomOut)) / (mean(best) - mean(zoomOut));
  }

  private static double mean(List<Double> values) {
    return values.stream().mapToDouble(value -> value).average().orElse(0);
  }

  /** Normalises a score: 0 is the score of zoom-out, 1 the best possible score. */
  double normalized(int episode, double score) {
    double lowest = zoomOut.get(episode);
    return (score - lowest) / (best.get(episode) - lowest);
  }
}
