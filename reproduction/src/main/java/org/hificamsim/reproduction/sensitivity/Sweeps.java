package org.hificamsim.reproduction.sensitivity;

import static org.hificamsim.reproduction.ReproductionPlans.CAMSIM;
import static org.hificamsim.reproduction.ReproductionPlans.EPSILON_GREEDY;
import static org.hificamsim.reproduction.ReproductionPlans.HIFI;
import static org.hificamsim.reproduction.ReproductionPlans.OPTIMAL;
import static org.hificamsim.reproduction.ReproductionPlans.QB_SARSA;
import static org.hificamsim.reproduction.ReproductionPlans.SARSA;
import static org.hificamsim.reproduction.ReproductionPlans.ZOOM_OUT;

import java.util.LinkedHashMap;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.BiFunction;
import java.util.function.Function;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.TargetSpec;
import org.hificamsim.hifi.model.PublishedModels;
import org.hificamsim.hifi.optics.Optics;
import org.hificamsim.reproduction.Layout;
import org.hificamsim.reproduction.ReproductionPlans;
import org.hificamsim.reproduction.sensitivity.Sweeps.ParameterSweep.Variant;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Settings;

/** The sweeps: each open parameter around its default ({@code docs/reproduction.md}). */
public final class Sweeps {
  private static final List<String> ALL = List.of(ZOOM_OUT, EPSILON_GREEDY, SARSA, QB_SARSA);
  private static final List<String> LEARNERS = List.of(EPSILON_GREEDY, SARSA, QB_SARSA);
  private static final List<String> TEMPORAL = List.of(SARSA, QB_SARSA);

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
    this.hifi = detection(HIFI);
    this.camsim = detection(CAMSIM);
  }

  /** The names of the scenarios that the sweeps need. */
  public static List<String> scenarioNames() {
    return Layout.SCENARIOS;
  }

  /** Every sweep, in the order of files. */
  List<ParameterSweep> all() {
    Optics optics = PublishedModels.published().optics();
    return List.of(
        sweep(
            "threshold-hifi",
            "detection threshold of " + hifi.name(),
            "0.03 0.04 0.0441 0.05 0.06 0.08",
            hifi.threshold(),
            one -> one.withHifi(detection(hifi.name() + "@" + one.value()))),
        sweep(
            "threshold-camsim",
            "detection threshold of " + camsim.name(),
            "0.15 0.25 0.35 0.45 0.55",
            camsim.threshold(),
            one -> one.withCamSim(detection(camsim.name() + "@" + one.value()))),
        world(
            "targets",
            "number of targets",
            "1 2 3 4 5 6 8",
            3,
            (scenario, count) -> ChangedWorld.withTargets(scenario, count.intValue())),
        options(
            "gamma",
            "discount factor of SARSA and QB-SARSA",
            "0 0.3 0.6 0.8 0.9 0.95 0.99",
            "0.9",
            TEMPORAL),
        options("epsilon", "probability of exploring", "0.01 0.05 0.1 0.2 0.3", "0.1", LEARNERS),
        options("k", "cameras that QB-SARSA asks", "0 1 2 4 6 8", "4", List.of(QB_SARSA)),
        options(
            "reward", "reading of Eq 7.5", "count-change sign literal", "count-change", TEMPORAL),
        world(
            "size",
            "targets' size q, m",
            "0.3 0.4 0.45 0.5 0.55 0.6 0.66",
            TargetSpec.DEFAULT_SIZE,
            ChangedWorld::withSize),
        world(
            "optics",
            "focal length of the narrowest level, m",
            "0.03 0.05 0.07 0.085 0.1",
            optics.longestFocalLength(),
            (scenario, z) -> ChangedWorld.withFocalLength(scenario, optics, z)),
        sweep(
            "f",
            "feature abstraction f of the hi-fi model",
            "lin pinhole power sr svr-lin",
            "lin",
            one -> one.withHifi(detection("hifi:orb-" + one.value()))),
        sweep(
            "g",
            "detector g of the hi-fi model",
            "orb sift surf",
            "orb",
            one -> one.withHifi(detection("hifi:" + one.value() + "-lin"))),
        options(
            "state",
            "state of SARSA and QB-SARSA",
            "level-count count none",
            "level-count",
            TEMPORAL),
        sweep(
            "formula",
            "formula of CamSim's model",
            "camsim-range camsim-standard camsim-visibility geometric",
            camsim.name(),
            one -> one.withCamSim(detection(one.value()))),
        world(
            "speed", "targets' speed, m a step", "0.25 0.5 1.0 2.0", 1.0, ChangedWorld::withSpeed),
        world(
            "radii",
            "widest level's radius, m, the others in proportion",
            "6.0 6.75 7.5 8.25 9.0",
            7.5,
            ChangedWorld::withWidestRadius),
        options(
            "alpha",
            "learning rate of SARSA and QB-SARSA",
            "0.05 0.1 0.2 0.3 0.5",
            "0.1",
            TEMPORAL),
        options("q0", "value of every action at first", "-3 0 1 3", "0", TEMPORAL),
        options("ties", "best of equally good levels", "widest narrowest", "widest", LEARNERS),
        sweep(
            "greedy",
            "reading of thesis 7.4.1's greedy, by which all are divided",
            "optimal one-hop one-hop:ties=narrowest",
            OPTIMAL,
            one -> one.withGreedy(one.value())));
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
            plans.add(asked.plan(scenario, detection, variant.greedy()));
          }
        }
      }
    }
    return List.copyOf(plans);
  }

  private Detection detection(String name) {
    return ReproductionPlans.detection(name, models);
  }

  /** A number that scenarios are changed by. */
  private ParameterSweep world(
      String parameter,
      String meaning,
      String values,
      Object standard,
      BiFunction<Scenario, Double, Scenario> change) {
    UnaryOperator<Variant> changed =
        one -> one.withScenarios(of -> change.apply(of, Double.valueOf(one.value())));
    return sweep(parameter, meaning, values, standard, changed);
  }

  /** An option of some policies. */
  private ParameterSweep options(
      String option, String meaning, String values, String standard, List<String> policies) {
    return sweep(option, meaning, values, standard, policies, one -> one.withOption(option));
  }

  private ParameterSweep sweep(
      String parameter,
      String meaning,
      String values,
      Object standard,
      UnaryOperator<Variant> change) {
    return sweep(parameter, meaning, values, standard, ALL, change);
  }

  /**
   * @param values between blanks
   * @param standard the default, one of them
   * @param change what another value changes
   */
  private ParameterSweep sweep(
      String parameter,
      String meaning,
      String values,
      Object standard,
      List<String> policies,
      UnaryOperator<Variant> change) {
    Map<String, String> specs = new LinkedHashMap<>();
    policies.forEach(policy -> specs.put(policy, policy));
    List<Variant> variants =
        Stream.of(values.split(" "))
            .map(
                value ->
                    new Variant(
                        value,
                        value.equals(standard.toString()),
                        scenarios,
                        hifi,
                        camsim,
                        specs,
                        OPTIMAL))
            .map(one -> one.standard() ? one : change.apply(one))
            .toList();
    return new ParameterSweep(parameter, meaning, variants);
  }

  /**
   * A parameter with the values that are tried, rising.
   *
   * @param parameter name in files
   * @param meaning for people
   */
  record ParameterSweep(String parameter, String meaning, List<Variant> variants) {
    /** The policies that the parameter can change. */
    List<String> policies() {
      return List.copyOf(variants.get(0).policies().keySet());
    }

    /**
     * One value of one parameter, everything else at its default.
     *
     * @param standard whether the value is the default
     * @param scenarios those of Table 7.1, by their names there
     * @param policies what is run for each policy that the parameter can change, by its name
     * @param greedy the policy by whose performance all others are divided
     */
    record Variant(
        String value,
        boolean standard,
        Map<String, Scenario> scenarios,
        Detection hifi,
        Detection camsim,
        Map<String, String> policies,
        String greedy) {
      /** Both detection models. */
      List<Detection> detections() {
        return List.of(camsim, hifi);
      }

      Variant withHifi(Detection other) {
        return new Variant(value, standard, scenarios, other, camsim, policies, greedy);
      }

      Variant withCamSim(Detection other) {
        return new Variant(value, standard, scenarios, hifi, other, policies, greedy);
      }

      Variant withScenarios(UnaryOperator<Scenario> change) {
        Map<String, Scenario> changed = new LinkedHashMap<>();
        scenarios.forEach((name, scenario) -> changed.put(name, change.apply(scenario)));
        return new Variant(value, standard, changed, hifi, camsim, policies, greedy);
      }

      Variant withOption(String option) {
        Map<String, String> changed = new LinkedHashMap<>();
        policies.forEach((name, spec) -> changed.put(name, spec + ":" + option + "=" + value));
        return new Variant(value, standard, scenarios, hifi, camsim, changed, greedy);
      }

      Variant withGreedy(String policy) {
        return new Variant(value, standard, scenarios, hifi, camsim, policies, policy);
      }
    }
  }
}
