package org.hificamsim.profiling.trial;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.FittedModel;
import org.hificamsim.profiling.fit.Groups;
import org.hificamsim.profiling.fit.Recommendation;
import org.hificamsim.profiling.measure.Measurement;

/**
 * Sets photos up again in the simulator, and asks it what it detects: each photo alone, and targets
 * before several cameras, whose photos are drawn. Every photo is asked of a model that was fitted
 * without its object (without its fold, where there is one object).
 */
public final class TrialRun {
  /** How many cameras look at each target. */
  public static final int CAMERAS = 3;

  private static final int SCENES = 1000;

  private final FittedModel model;
  private final FitResult result;
  private final double threshold;
  private final double farthest;
  private final Map<Measurement, Integer> groups = new HashMap<>();
  private final List<UnseenModel> models = new ArrayList<>();

  private TrialRun(FittedModel model) {
    this.model = model;
    this.result = model.result();
    this.threshold = model.detection("trial").defaultThreshold();
    this.farthest =
        result.measurements().stream().mapToDouble(Measurement::distance).max().orElseThrow();
    Groups unseen = result.unseen();
    for (int group = 0; group < unseen.count(); group++) {
      models.add(new UnseenModel(model.without(group), threshold));
      for (int row : unseen.rows().get(group)) {
        groups.put(result.measurements().get(row), group);
      }
    }
  }

  /** Of the model of each detector that is recommended; the same on any number of threads. */
  public static List<Trials> all(FitResult result, int threads) {
    List<FittedModel> models =
        Recommendation.all(result).stream().flatMap(one -> one.model().stream()).toList();
    return Parallel.map(models, threads, TrialRun::of);
  }

  /** Of one model. */
  public static Trials of(FittedModel model) {
    return new TrialRun(model).trials();
  }

  private Trials trials() {
    Covered.Sum measured = new Covered.Sum();
    Covered.Sum simulated = new Covered.Sum();
    Covered.Sum measuredByChance = new Covered.Sum();
    Covered.Sum expected = new Covered.Sum();
    double error = 0;
    List<List<Measurement>> objects = objects();
    SplittableRandom random = new SplittableRandom(0);
    for (int i = 0; i < SCENES; i++) {
      Scene scene = Scene.drawn(objects.get(random.nextInt(objects.size())), CAMERAS, random);
      Outcome outcome = outcome(scene);
      measured.add(outcome.measured());
      simulated.add(outcome.simulated());
      measuredByChance.add(outcome.measuredByChance());
      expected.add(outcome.once(), outcome.more(), outcome.meanK());
      error += Math.abs(outcome.measured() - outcome.simulated());
    }
    return new Trials(
        model,
        threshold,
        result.measurements().stream().map(this::trial).toList(),
        SCENES,
        measured.mean(),
        simulated.mean(),
        error / SCENES,
        measuredByChance.mean(),
        model.detection("trial").scatter().map(any -> expected.mean()));
  }

  /** Photos that a scene may show together: of one object, and unseen by one model. */
  private List<List<Measurement>> objects() {
    Map<Object, List<Measurement>> objects = new LinkedHashMap<>();
    for (Measurement photo : result.measurements()) {
      objects
          .computeIfAbsent(
              List.of(photo.object(), photo.size(), groups.get(photo)), any -> new ArrayList<>())
          .add(photo);
    }
    return List.copyOf(objects.values());
  }

  private Trial trial(Measurement photo) {
    Outcome outcome = outcome(Scene.of(photo));
    return new Trial(
        photo,
        outcome.measured() > 0,
        outcome.simulated() > 0,
        outcome.measuredByChance() > 0,
        outcome.once());
  }

  /** What photos and simulator say of a scene; NaN by chance where the model has no scatter. */
  private record Outcome(
      long measured,
      long simulated,
      long measuredByChance,
      double once,
      double more,
      double meanK) {}

  private Outcome outcome(Scene scene) {
    UnseenModel unseen = models.get(groups.get(scene.photos().get(0)));
    unseen.begin();
    Scenario scenario = scene.scenario(result.camera(), farthest);
    long simulated = Simulator.coverage(scenario, unseen.certain()).detections();
    long measured = reaching(scene, threshold);
    if (unseen.chance().isEmpty()) {
      return new Outcome(measured, simulated, 0, Double.NaN, Double.NaN, Double.NaN);
    }
    Detection chance = unseen.chance().get();
    StepCoverage expected = Simulator.coverage(scenario, chance);
    return new Outcome(
        measured,
        simulated,
        reaching(scene, chance.threshold()),
        expected.expected().chanceOfOne(0),
        expected.expected().chanceOfMore(0),
        expected.expected().meanK());
  }

  private long reaching(Scene scene, double confidence) {
    return scene.photos().stream()
        .filter(photo -> photo.confidence(model.detector()) >= confidence)
        .count();
  }
}
