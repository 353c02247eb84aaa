package org.hificamsim.runs.compare;

import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.stream.Collectors;
import org.hificamsim.runs.RunPlan;

/**
 * Finds the results of a comparison by the names of scenario, detection model and policy, and
 * groups results in the order in which they are given.
 */
public final class Cases {
  private record Name(String scenario, String detection, String policy) {
    static Name of(RunPlan plan) {
      return new Name(plan.scenario().name(), plan.detection().name(), plan.policy());
    }
  }

  private final Map<Name, CaseResult> cases = new LinkedHashMap<>();

  public Cases(List<CaseResult> results) {
    results.forEach(result -> cases.put(Name.of(result.plan()), result));
  }

  /**
   * The result of a case.
   *
   * @throws IllegalArgumentException when the case was not run
   */
  public CaseResult find(String scenario, String detection, String policy) {
    Name name = new Name(scenario, detection, policy);
    CaseResult found = cases.get(name);
    if (found == null) {
      throw new IllegalArgumentException("no result for " + name);
    }
    return found;
  }

  public static Map<String, List<CaseResult>> byScenario(List<CaseResult> cases) {
    return group(cases, result -> result.plan().scenario().name());
  }

  public static Map<String, List<CaseResult>> byDetection(List<CaseResult> cases) {
    return group(cases, result -> result.plan().detection().name());
  }

  public static Map<String, List<CaseResult>> byPolicy(List<CaseResult> cases) {
    return group(cases, result -> result.plan().policy());
  }

  static <K> Map<K, List<CaseResult>> group(List<CaseResult> cases, Function<CaseResult, K> key) {
    return cases.stream()
        .collect(Collectors.groupingBy(key, LinkedHashMap::new, Collectors.toList()));
  }
}
