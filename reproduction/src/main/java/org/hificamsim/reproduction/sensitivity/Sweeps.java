package org.hificamsim.reproduction.sensitivity;

import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.hifi.model.PublishedModels;
import org.hificamsim.hifi.optics.Optics;
import org.hificamsim.reproduction.Layout;
import org.hificamsim.reproduction.ReproductionPlans;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Settings;

/** The sweeps: each open parameter around its default ({@code docs/reproduction.md}). */
public final class Sweeps {
  private static final List<String> ALL =
      List.of(
          ReproductionPlans.ZOOM_OUT,
          ReproductionPlans.EPSILON_GREEDY,
          ReproductionPlans.SARSA,
          ReproductionPlans.QB_SARSA);
  private static final List<String> LEARNERS =
      List.of(
          ReproductionPlans.EPSILON_GREEDY, ReproductionPlans.SARSA, ReproductionPlans.QB_SARSA);
  private static final List<String> TEMPORAL =
      List.of(ReproductionPlans.SARSA, ReproductionPlans.QB_SARSA);
  private static final int TARGETS = 3;

  private final Map<String, Scenario> scenarios;
  private final Function<String, DetectionModel> models;
  private final Detection hifi;
  private final Detection camsim;

  /**
   * @param scenarios those of Table 7.1, by name
   */
  public Sweeps(Map<String, Scenario> scenarios, Function<String, DetectionModel> models) {
    this.scenarios = scenarios;
    this.models = models;
    this.hifi = ReproductionPlans.detection(ReproductionPlans.HIFI, models);
    this.camsim = ReproductionPlans.detection(ReproductionPlans.CAMSIM, models);
  }

  /** The names of the scenarios that the sweeps need. */
  public static List<String> scenarioNames() {
    return Layout.SCENARIOS;
  }

  /** Every sweep, in the order of files. */
  List<ParameterSweep> all() {
    return List.of(
        new ParameterSweep(
            "threshold-hifi",
            "detection threshold of " + hifi.name(),
            thresholds(hifi, 0.03, 0.04, 0.0441, 0.05, 0.06, 0.08)),
        new ParameterSweep(
            "threshold-camsim",
            "detection threshold of " + camsim.name(),
            thresholds(camsim, 0.15, 0.25, 0.35, 0.45, 0.55)),
        new ParameterSweep("targets", "number of targets", targets(1, 2, 3, 4, 5, 6, 8)),
        new ParameterSweep(
            "gamma",
            "discount factor of SARSA and QB-SARSA",
            options(TEMPORAL, "gamma", "0.9", "0", "0.3", "0.6", "0.8", "0.9", "0.95", "0.99")),
        new ParameterSweep(
            "epsilon",
            "probability of exploring",
            options(LEARNERS, "epsilon", "0.1", "0.01", "0.05", "0.1", "0.2", "0.3")),
        new ParameterSweep(
            "k",
            "cameras that QB-SARSA asks",
            options(List.of(ReproductionPlans.QB_SARSA), "k", "4", "0", "1", "2", "4", "6", "8")),
        new ParameterSweep(
            "reward",
            "reading of Eq 7.5",
            options(TEMPORAL, "reward", "count-change", "count-change", "sign", "literal")),
        new ParameterSweep(
            "size", "targets' size q, m", sizes(0.3, 0.4, 0.45, 0.5, 0.55, 0.6, 0.66)),
        new ParameterSweep(
            "optics",
            "focal length of the narrowest level, m",
            focalLengths(0.03, 0.05, 0.07, 0.085, 0.1)),
        new ParameterSweep(
            "f",
            "feature abstraction f of the hi-fi model",
            hifi("hifi:orb-%s", "lin", "lin", "pinhole", "power", "sr", "svr-lin")),
        new ParameterSweep(
            "g",
            "detector g of the hi-fi model",
            hifi("hifi:%s-lin", "orb", "orb", "sift", "surf")),
        new ParameterSweep(
            "state",
            "state of SARSA and QB-SARSA",
            options(TEMPORAL, "state", "level-count", "level-count", "count", "none")),
        new ParameterSweep(
            "formula",
            "formula of CamSim's model",
            formulas("camsim-range", "camsim-standard", "camsim-visibility", "geometric")));
  }

  /** The plans of all sweeps, each once. */
  public List<RunPlan> plans(Settings asked) {
    Set<RunPlan> plans = new LinkedHashSet<>();
    for (ParameterSweep sweep : all()) {
      for (Variant variant : sweep.variants()) {
        for (Scenario scenario : variant.scenarios().values()) {
          for (Detection detection : variant.detections()) {
            for (String policy : variant.policies().values()) {
              plans.add(asked.plan(scenario, detection, policy));
            }
          }
        }
      }
    }
    return List.copyOf(plans);
  }

  private List<Variant> thresholds(Detection usual, double... thresholds) {
    List<Variant> variants = new ArrayList<>();
    for (double threshold : thresholds) {
      boolean standard = threshold == usual.threshold();
      Detection changed =
          standard ? usual : ReproductionPlans.detection(usual.name() + "@" + threshold, models);
      variants.add(
          new Variant(
              String.valueOf(threshold),
              standard,
              scenarios,
              usual == hifi ? changed : hifi,
              usual == camsim ? changed : camsim,
              specs(ALL, "")));
    }
    return variants;
  }

  private List<Variant> targets(int... numbers) {
    List<Variant> variants = new ArrayList<>();
    for (int number : numbers) {
      variants.add(worlds(number, number == TARGETS, scenario -> TargetCount.of(scenario, number)));
    }
    return variants;
  }

  private List<Variant> sizes(double... sizes) {
    List<Variant> variants = new ArrayList<>();
    for (double size : sizes) {
      boolean standard = size == TargetSpec.DEFAULT_SIZE;
      variants.add(worlds(size, standard, scenario -> ChangedWorld.withSize(scenario, size)));
    }
    return variants;
  }

  private List<Variant> focalLengths(double... lengths) {
    Optics optics = PublishedModels.published().optics();
    List<Variant> variants = new ArrayList<>();
    for (double length : lengths) {
      boolean standard = length == optics.longestFocalLength();
      variants.add(
          worlds(
              length,
              standard,
              scenario -> ChangedWorld.withFocalLength(scenario, optics, length)));
    }
    return variants;
  }

  private Variant worlds(Number value, boolean standard, UnaryOperator<Scenario> change) {
    Map<String, Scenario> changed = new LinkedHashMap<>();
    scenarios.forEach(
        (name, scenario) -> changed.put(name, standard ? scenario : change.apply(scenario)));
    return variant(String.valueOf(value), standard, changed, specs(ALL, ""));
  }

  /** The hi-fi models whose names follow a pattern, each at its default threshold. */
  private List<Variant> hifi(String pattern, String standard, String... values) {
    List<Variant> variants = new ArrayList<>();
    for (String value : values) {
      boolean isStandard = value.equals(standard);
      Detection changed =
          isStandard ? hifi : ReproductionPlans.detection(pattern.formatted(value), models);
      variants.add(new Variant(value, isStandard, scenarios, changed, camsim, specs(ALL, "")));
    }
    return variants;
  }

  private List<Variant> formulas(String... names) {
    List<Variant> variants = new ArrayList<>();
    for (String name : names) {
      boolean standard = name.equals(camsim.name());
      Detection changed = standard ? camsim : ReproductionPlans.detection(name, models);
      variants.add(new Variant(name, standard, scenarios, hifi, changed, specs(ALL, "")));
    }
    return variants;
  }

  private List<Variant> options(
      List<String> policies, String option, String standard, String... values) {
    List<Variant> variants = new ArrayList<>();
    for (String value : values) {
      boolean isStandard = value.equals(standard);
      String options = isStandard ? "" : ":" + option + "=" + value;
      variants.add(variant(value, isStandard, scenarios, specs(policies, options)));
    }
    return variants;
  }

  private Variant variant(
      String value, boolean standard, Map<String, Scenario> worlds, Map<String, String> specs) {
    return new Variant(value, standard, worlds, hifi, camsim, specs);
  }

  private static Map<String, String> specs(List<String> policies, String options) {
    Map<String, String> specs = new LinkedHashMap<>();
    policies.forEach(policy -> specs.put(policy, policy + options));
    return specs;
  }
}
