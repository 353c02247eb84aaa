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

/**
 * A frozen task as its file declares it, and what its testing episodes are scored by. A change
 * makes another one, with the next version in its name.
 *
 * @param scenario a file next to that of the tasks
 * @param steps of an episode
 * @param unmapped which obstacles the cameras' map lacks, by their number in the scenario, from 0
 * @param hash of all that it is: see {@link #digest}
 * @param zoomOut mean score of a step of {@code zoom-out} in each testing episode: 0 of the scale
 * @param best the same of the optimum, or of a bound where it is not proven: 1 of the scale
 * @param proven whether the optimum is proven in every step, by testing episode
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
  /** Seeds of training are 0 to this; other numbers stand for one of them. */
  public static final int TRAINING = 1_000_000;

  /** The seeds of the testing episodes. */
  public static final List<Long> TESTING =
      LongStream.rangeClosed(TRAINING + 1, TRAINING + 10).boxed().toList();

  /** The site as a seed has it, with all that the task says. */
  Scenario draw(Scenario site, long seed) {
    boolean isTesting = TESTING.contains(seed);
    long of = isTesting ? seed : Math.floorMod(seed, TRAINING);
    Scenario drawn =
        layout
            .draw(site, of, isTesting)
            .with(Scenario.DETECTION, detection)
            .with(Scenario.OBJECTIVE, Objective.parse(objective))
            .with(Scenario.CHANNEL, ChannelModel.parse(channel))
            .with(Scenario.STEPS, steps);
    List<Obstacle> all = drawn.obstacles();
    List<Obstacle> known =
        IntStream.range(0, all.size())
            .filter(i -> !unmapped.contains(i))
            .mapToObj(all::get)
            .toList();
    return unmapped.isEmpty() ? drawn : drawn.with(Scenario.MAP, known);
  }

  RunPlan plan(Catalogue catalogue, Scenario drawn, String policy, long seed) {
    DetectionSpec detects = DetectionSpec.parse(detection, catalogue::detection);
    return new RunPlan(drawn, detects.detection(Settings.NONE, drawn), policy, steps, seed, 1);
  }

  /**
   * The hash of what is declared, of the layouts of all testing seeds and of the first training
   * ones, and of what the scale is.
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

  /** A score between that of zoom-out, 0, and the best that is possible, 1. */
  double normalized(int episode, double score) {
    double zero = zoomOut.get(episode);
    return (score - zero) / (best.get(episode) - zero);
  }
}
