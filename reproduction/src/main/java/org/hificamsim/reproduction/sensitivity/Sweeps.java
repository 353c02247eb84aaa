package org.hificamsim.reproduction.sensitivity;

import static org.hificamsim.reproduction.ReproductionPlans.CAMSIM;
import static org.hificamsim.reproduction.ReproductionPlans.EPSILON_GREEDY;
import static org.hificamsim.reproduction.ReproductionPlans.HIFI;
import static org.hificamsim.reproduction.ReproductionPlans.OPTIMAL;
import static org.hificamsim.reproduction.ReproductionPlans.QB_SARSA;
import static org.hificamsim.reproduction.ReproductionPlans.SARSA;
import static org.hificamsim.reproduction.ReproductionPlans.ZOOM_OUT;

import com.fasterxml.jackson.databind.ObjectMapper;
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
import org.hificamsim.core.file.Io;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.hifi.model.PublishedModels;
import org.hificamsim.reproduction.Layout;
import org.hificamsim.reproduction.ReproductionPlans;
import org.hificamsim.reproduction.sensitivity.Sweeps.ParameterSweep.Variant;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Settings;

/** The sweeps: each open parameter around its default ({@code docs/reproduction.md}). */
public final class Sweeps {
  private static final List<String> ALL = List.of(ZOOM_OUT, EPSILON_GREEDY, SARSA, QB_SARSA);
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

  /**
   * A sweep as the resource {@code sweeps.json} declares it.
   *
   * @param values rising, between blanks; the default has a star before it
   * @param policies that it can change; where none are named, all
   */
  private record Declared(String parameter, String values, String meaning, List<String> policies) {}

  /** Every sweep, in the order of files. */
  List<ParameterSweep> all() {
    byte[] json = Io.resource(Sweeps.class, "sweeps.json");
    Declared[] declared = Io.get(() -> new ObjectMapper().readValue(json, Declared[].class));
    return Stream.of(declared).map(this::sweep).toList();
  }

  private ParameterSweep sweep(Declared declared) {
    List<String> policies = declared.policies == null ? ALL : declared.policies;
    Map<String, String> specs = new LinkedHashMap<>();
    policies.forEach(policy -> specs.put(policy, policy));
    List<Variant> variants =
        Stream.of(declared.values.split(" "))
            .map(value -> variant(declared.parameter, value, specs))
            .toList();
    return new ParameterSweep(declared.parameter, declared.meaning, variants);
  }

  private Variant variant(String parameter, String value, Map<String, String> policies) {
    boolean standard = value.startsWith("*");
    String plain = standard ? value.substring(1) : value;
    Variant defaults = new Variant(plain, standard, scenarios, hifi, camsim, policies, OPTIMAL);
    return standard ? defaults : changed(defaults, parameter, plain);
  }

  /**
   * The defaults with another value of a parameter; those without a line are options of policies.
   */
  private Variant changed(Variant one, String parameter, String value) {
    return switch (parameter) {
      case "threshold-hifi" -> one.withHifi(detection(HIFI + "@" + value));
      case "threshold-camsim" -> one.withCamSim(detection(CAMSIM + "@" + value));
      case "f" -> one.withHifi(detection("hifi:orb-" + value));
      case "g" -> one.withHifi(detection("hifi:" + value + "-lin"));
      case "formula" -> one.withCamSim(detection(value));
      case "greedy" -> one.withGreedy(value);
      case "targets" -> world(one, (of, count) -> ChangedWorld.withTargets(of, count.intValue()));
      case "size" -> world(one, ChangedWorld::withSize);
      case "optics" -> world(one, Sweeps::withFocalLength);
      case "speed" -> world(one, ChangedWorld::withSpeed);
      case "radii" -> world(one, ChangedWorld::withWidestRadius);
      default -> one.withOption(parameter);
    };
  }

  private static Scenario withFocalLength(Scenario scenario, double z) {
    return ChangedWorld.withFocalLength(scenario, PublishedModels.published().optics(), z);
  }

  private static Variant world(Variant one, BiFunction<Scenario, Double, Scenario> change) {
    return one.withScenarios(of -> change.apply(of, Double.valueOf(one.value())));
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
