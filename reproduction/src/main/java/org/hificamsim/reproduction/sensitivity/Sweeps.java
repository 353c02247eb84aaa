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

/** The sweeps of all open parameters around their defaults ({@code docs/reproduction.md}). */
public final class Sweeps {
  private static final List<String> ALL_POLICIES =
      List.of(ZOOM_OUT, EPSILON_GREEDY, SARSA, QB_SARSA);
  private final Map<String, Scenario> scenarios;
  private final Function<String, DetectionModel> models;
  private final Detection hifi;
  private final Detection camsim;

  /**
   * @param scenarios the scenarios of Table 7.1, by name
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
   * The declaration of a sweep in the resource {@code sweeps.json}.
   *
   * @param values the values in ascending order, separated by blanks; a star marks the default
   * @param policies the policies that the parameter can change; null for all
   */
  private record SweepDeclaration(
      String parameter, String values, String meaning, List<String> policies) {}

  /** Returns all sweeps, in the order of files. */
  List<ParameterSweep> all() {
    byte[] json = Io.resource(Sweeps.class, "sweeps.json");
    SweepDeclaration[] declared =
        Io.get(() -> new ObjectMapper().readValue(json, SweepDeclaration[].class));
    return Stream.of(declared).map(this::sweep).toList();
  }

  private ParameterSweep sweep(SweepDeclaration declared) {
    List<String> policies = declared.policies == null ? ALL_POLICIES : declared.policies;
    Map<String, String> specs = new LinkedHashMap<>();
    policies.forEach(policy -> specs.put(policy, policy));
    List<Variant> variants =
        Stream.of(declared.values.split(" "))
            .map(value -> variant(declared.parameter, value, specs))
            .toList();
    return new ParameterSweep(declared.parameter, declared.meaning, variants);
  }

  private Variant variant(String parameter, String value, Map<String, String> policies) {
    boolean isDefault = value.startsWith("*");
    String text = isDefault ? value.substring(1) : value;
    Variant defaults = new Variant(text, isDefault, scenarios, hifi, camsim, policies, OPTIMAL);
    return isDefault ? defaults : changed(defaults, parameter, text);
  }

  /**
   * The defaults with another value of a parameter; a parameter without a line here is an option of
   * policies.
   */
  private Variant changed(Variant defaults, String parameter, String value) {
    return switch (parameter) {
      case "threshold-hifi" -> defaults.withHifi(detection(HIFI + "@" + value));
      case "threshold-camsim" -> defaults.withCamSim(detection(CAMSIM + "@" + value));
      case "f" -> defaults.withHifi(detection("hifi:orb-" + value));
      case "g" -> defaults.withHifi(detection("hifi:" + value + "-lin"));
      case "formula" -> defaults.withCamSim(detection(value));
      case "greedy" -> defaults.withGreedy(value);
      case "targets" ->
          withChangedWorld(
              defaults, (scenario, count) -> ChangedWorld.withTargets(scenario, count.intValue()));
      case "size" -> withChangedWorld(defaults, ChangedWorld::withSize);
      case "optics" -> withChangedWorld(defaults, Sweeps::withFocalLength);
      case "speed" -> withChangedWorld(defaults, ChangedWorld::withSpeed);
      case "radii" -> withChangedWorld(defaults, ChangedWorld::withWidestRadius);
      default -> defaults.withOption(parameter);
    };
  }

  private static Scenario withFocalLength(Scenario scenario, double focalLength) {
    return ChangedWorld.withFocalLength(
        scenario, PublishedModels.published().optics(), focalLength);
  }

  private static Variant withChangedWorld(
      Variant defaults, BiFunction<Scenario, Double, Scenario> change) {
    return defaults.withScenarios(
        scenario -> change.apply(scenario, Double.valueOf(defaults.value())));
  }

  /** The plans of all sweeps, each once. */
  public List<RunPlan> plans(Settings settings) {
    Set<RunPlan> plans = new LinkedHashSet<>();
    for (ParameterSweep sweep : all()) {
      for (Variant variant : sweep.variants()) {
        for (Scenario scenario : variant.scenarios().values()) {
          for (Detection detection : variant.detections()) {
            for (String policy : variant.policies().values()) {
              plans.add(settings.plan(scenario, detection, policy));
            }
            plans.add(settings.plan(scenario, detection, variant.greedy()));
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
   * A parameter with its values in ascending order.
   *
   * @param parameter the parameter's name in files
   * @param meaning the meaning of the parameter in words
   */
  record ParameterSweep(String parameter, String meaning, List<Variant> variants) {
    /** The policies that the parameter can change. */
    List<String> policies() {
      return List.copyOf(variants.get(0).policies().keySet());
    }

    /**
     * A value of a parameter, with all other parameters at their defaults.
     *
     * @param isDefault whether the value is the default
     * @param scenarios the scenarios of Table 7.1, perhaps changed, by their original names
     * @param policies policies with options, by the names of the policies that the parameter can
     *     change
     * @param greedy the policy whose performance divides that of all others
     */
    record Variant(
        String value,
        boolean isDefault,
        Map<String, Scenario> scenarios,
        Detection hifi,
        Detection camsim,
        Map<String, String> policies,
        String greedy) {
      /** Returns both detection models. */
      List<Detection> detections() {
        return List.of(camsim, hifi);
      }

      Variant withHifi(Detection other) {
        return new Variant(value, isDefault, scenarios, other, camsim, policies, greedy);
      }

      Variant withCamSim(Detection other) {
        return new Variant(value, isDefault, scenarios, hifi, other, policies, greedy);
      }

      Variant withScenarios(UnaryOperator<Scenario> change) {
        Map<String, Scenario> changed = new LinkedHashMap<>();
        scenarios.forEach((name, scenario) -> changed.put(name, change.apply(scenario)));
        return new Variant(value, isDefault, changed, hifi, camsim, policies, greedy);
      }

      Variant withOption(String option) {
        Map<String, String> changed = new LinkedHashMap<>();
        policies.forEach((name, spec) -> changed.put(name, spec + ":" + option + "=" + value));
        return new Variant(value, isDefault, scenarios, hifi, camsim, changed, greedy);
      }

      Variant withGreedy(String policy) {
        return new Variant(value, isDefault, scenarios, hifi, camsim, policies, policy);
      }
    }
  }
}
