package org.hificamsim.reproduction;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.function.Function;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Settings;

/**
 * The plans of all runs that Table 8.1, the figures and the statements need.
 *
 * @param scenarios the scenarios of Table 7.1 and {@link #ORIGIN}, by name
 * @param settings the settings of all runs, such as steps, seeds and repeats
 */
public record ReproductionPlans(Map<String, Scenario> scenarios, Settings settings) {
  public static final String HIFI = "hifi:orb-lin";
  public static final String CAMSIM = "camsim-range";

  /** CamSim's formula as the thesis prints it, Eq 6.2. */
  public static final String STANDARD = "camsim-standard";

  /** CamSim's model with the threshold that fits the table best over the hi-fi optimum. */
  public static final String CAMSIM_45 = "camsim-range@0.45";

  /** Scenario 6 with its rectangle about the centre of the field, another reading of the text. */
  public static final String ORIGIN = "cluster-scripted-origin";

  public static final String OPTIMAL = "optimal";

  /** All cameras always at the zoom level with a radius of 5 m. */
  static final String FIXED = "fixed:2";

  public static final String ZOOM_OUT = "zoom-out";
  public static final String EPSILON_GREEDY = "epsilon-greedy";
  static final String EXPLORE_ANY = "epsilon-greedy:explore=any";
  public static final String SARSA = "sarsa";
  public static final String QB_SARSA = "qb-sarsa";
  static final String STATE_COUNT = "sarsa:state=count";

  /** The greedy approach of thesis 7.4.1, read as moving one zoom level at a time. */
  static final String ONE_HOP = "one-hop";

  static final String REWARD_SIGN = "sarsa:reward=sign";
  static final String REWARD_LITERAL = "sarsa:reward=literal";

  /** The option of SARSA and QB-SARSA without a state. */
  static final String STATELESS = ":state=none";

  /** A combination of scenario, detection and policy by their names. */
  private record Case(String scenario, String detection, String policy) {}

  /** The names of the scenarios that are needed. */
  public static List<String> scenarioNames() {
    List<String> names = new ArrayList<>(Layout.SCENARIOS);
    names.add(ORIGIN);
    return names;
  }

  /** The plans, each once, including the optima. */
  public List<RunPlan> plans(Function<String, DetectionModel> models) {
    Map<String, Detection> detections =
        Stream.of(HIFI, CAMSIM, CAMSIM_45, STANDARD)
            .collect(Collectors.toMap(name -> name, name -> detection(name, models)));
    return cases().stream()
        .map(
            combination ->
                settings.plan(
                    scenarios.get(combination.scenario()),
                    detections.get(combination.detection()),
                    combination.policy()))
        .toList();
  }

  /** The detection of a name, with the threshold in the name or the default of the model. */
  public static Detection detection(String name, Function<String, DetectionModel> models) {
    return DetectionSpec.parse(name, models).detection(Settings.NONE);
  }

  private static Set<Case> cases() {
    Set<Case> cases = new LinkedHashSet<>();
    for (String scenario : Layout.SCENARIOS) {
      addTable(cases, scenario, List.of(CAMSIM, HIFI));
      add(cases, scenario, CAMSIM_45, PublishedCell.POLICIES);
      add(cases, scenario, HIFI, List.of(QB_SARSA, SARSA + STATELESS, QB_SARSA + STATELESS));
      add(cases, scenario, HIFI, List.of(epsilon(EPSILON_GREEDY, 0.01)));
      add(cases, scenario, HIFI, List.of(epsilon(EPSILON_GREEDY, 0.001)));
      add(cases, scenario, HIFI, List.of(EXPLORE_ANY));
      add(cases, scenario, CAMSIM, List.of(EXPLORE_ANY));
    }
    addTable(cases, ORIGIN, List.of(CAMSIM, HIFI));
    add(cases, Layout.LATTICE.random(), HIFI, List.of("random"));
    add(cases, Layout.LATTICE.scripted(), HIFI, List.of(epsilon(SARSA, 0.2), epsilon(SARSA, 0.3)));
    add(cases, Layout.LATTICE.scripted(), HIFI, List.of(alpha(0.2), alpha(0.3), STATE_COUNT));
    for (String scenario : Layout.SCENARIOS) {
      addTable(cases, scenario, List.of(STANDARD));
      add(cases, scenario, CAMSIM, List.of(FIXED, ONE_HOP, REWARD_SIGN, REWARD_LITERAL));
      add(cases, scenario, HIFI, List.of(FIXED, ONE_HOP, REWARD_SIGN, REWARD_LITERAL));
    }
    return cases;
  }

  private static void addTable(Set<Case> cases, String scenario, List<String> detections) {
    for (String detection : detections) {
      add(cases, scenario, detection, List.of(OPTIMAL));
      add(cases, scenario, detection, PublishedCell.POLICIES);
    }
  }

  private static void add(
      Set<Case> cases, String scenario, String detection, List<String> policies) {
    policies.forEach(policy -> cases.add(new Case(scenario, detection, policy)));
  }

  static String epsilon(String policy, double epsilon) {
    return policy + ":epsilon=" + epsilon;
  }

  static String alpha(double alpha) {
    return SARSA + ":alpha=" + alpha;
  }
}
