package org.hificamsim.profiling.trial;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.function.Function;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionRule;
import org.hificamsim.core.detection.DetectionRule.Chance;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.FittedModel;
import org.hificamsim.profiling.fit.Groups;
import org.hificamsim.profiling.fit.Recommendation;
import org.hificamsim.profiling.measure.Measurement;
import org.hificamsim.profiling.trial.Trials.Covered;

/**
 * Sets photos up again in the simulator, and asks it what it detects: each photo alone, and targets
 * before several cameras, whose photos are drawn. Every photo is asked of a model that was fitted
 * without its object (without its fold, where there is one object).
 */
public final class TrialRun {
  /** How many cameras look at each target. */
  public static final int CAMERAS = 3;

  static final int SCENES = 1000;

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
      models.add(new UnseenModel(model.without(group)));
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
    List<List<Measurement>> objects = objects();
    SplittableRandom random = new SplittableRandom(0);
    List<SceneResult> scenes = new ArrayList<>();
    for (int i = 0; i < SCENES; i++) {
      List<Measurement> object = objects.get(random.nextInt(objects.size()));
      scenes.add(asked(Scene.drawn(object, CAMERAS, random)));
    }
    return new Trials(
        model,
        threshold,
        result.measurements().stream().map(this::trial).toList(),
        mean(scenes, scene -> Covered.by(scene.measured)),
        mean(scenes, scene -> Covered.by(scene.simulated)),
        mean(scenes, scene -> Covered.by(scene.measuredByChance)),
        model.detection("trial").scatter().map(any -> mean(scenes, SceneResult::expected)));
  }

  private static Covered mean(List<SceneResult> scenes, Function<SceneResult, Covered> part) {
    return Covered.mean(scenes.stream().map(part).toList());
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
    SceneResult alone = asked(Scene.of(photo));
    return new Trial(
        photo,
        alone.measured > 0,
        alone.simulated > 0,
        alone.measuredByChance > 0,
        alone.expected.once());
  }

  /**
   * By how many cameras a scene's target is covered.
   *
   * @param measured as the photos say
   * @param simulated as the simulator says
   * @param measuredByChance as the photos say by the threshold of {@code --detect chance}
   * @param expected as the simulator says by that rule; NaN where the model has no scatter
   */
  private record SceneResult(
      long measured, long simulated, long measuredByChance, Covered expected) {}

  private SceneResult asked(Scene scene) {
    UnseenModel unseen = models.get(groups.get(scene.photos().get(0)));
    unseen.begin();
    Scenario scenario = scene.scenario(result.camera(), farthest);
    long simulated = Scene.coverage(scenario, unseen.certain).detections();
    long measured = reaching(scene, threshold);
    if (unseen.chance.isEmpty()) {
      return new SceneResult(
          measured, simulated, 0, new Covered(Double.NaN, Double.NaN, Double.NaN));
    }
    StepCoverage coverage = Scene.coverage(scenario, unseen.chance.get());
    Covered expected =
        new Covered(
            coverage.expected().chanceOfOne(0),
            coverage.expected().chanceOfMore(0),
            coverage.expected().meanK());
    return new SceneResult(
        measured, simulated, reaching(scene, unseen.measuredByChance()), expected);
  }

  private long reaching(Scene scene, double confidence) {
    return scene.photos().stream()
        .filter(photo -> photo.confidence(model.detector()) >= confidence)
        .count();
  }

  /**
   * A model that has not seen some photos, as the simulator uses it. A {@link Detection} remembers
   * a table for each size and zoom level; where every photo has its own, that is too much to keep.
   */
  private static final class UnseenModel {
    private static final int MAX_USES = 256;

    private final HiFiDetection model;
    private int uses;

    /** By the threshold. */
    private Detection certain;

    /** By chance; empty where the model has no scatter. */
    private Optional<Detection> chance;

    UnseenModel(HiFiDetection model) {
      this.model = model;
    }

    /** The measured confidence that is a detection by chance. */
    double measuredByChance() {
      return model.scatter().orElseThrow().threshold(Chance.DEFAULT_ALPHA);
    }

    /** Begins another scene. */
    void begin() {
      if (uses++ % MAX_USES == 0) {
        certain = new Detection(model, model.defaultThreshold());
        chance =
            model
                .scatter()
                .map(any -> Detection.by(DetectionRule.parse("chance"), model.name(), model));
      }
    }
  }
}
