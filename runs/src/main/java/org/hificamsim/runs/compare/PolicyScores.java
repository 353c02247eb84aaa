package org.hificamsim.runs.compare;

import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.stream.Collectors;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.statistics.Strata;

/**
 * The results of a policy under a detection in all scenarios.
 *
 * @param cases the case of each scenario
 */
public record PolicyScores(List<CaseResult> cases) {
  /** The policies of cases, in the order in which they first occur. */
  public static List<PolicyScores> of(List<CaseResult> cases) {
    return Cases.group(
            cases, result -> List.of(result.plan().detection().name(), result.plan().policy()))
        .values()
        .stream()
        .map(PolicyScores::new)
        .toList();
  }

  /**
   * Sorts cases by their policies' scores under the last detection, which is the most real, the
   * best first; policies that tie keep their order.
   */
  public static List<CaseResult> byScore(List<CaseResult> cases) {
    Metric metric = Yardstick.metric(cases);
    String last = cases.get(cases.size() - 1).plan().detection().name();
    List<CaseResult> leading = Cases.byDetection(cases).get(last);
    Map<String, Double> means =
        Cases.byPolicy(leading).entrySet().stream()
            .collect(
                Collectors.toMap(Map.Entry::getKey, policy -> mean(policy.getValue(), metric)));
    return cases.stream()
        .sorted(
            Comparator.comparingDouble(result -> -means.getOrDefault(result.plan().policy(), 0.0)))
        .toList();
  }

  private static double mean(List<CaseResult> cases, Metric metric) {
    return cases.stream()
        .mapToDouble(result -> result.mean(metric).mean())
        .filter(Double::isFinite)
        .average()
        .orElse(0);
  }

  /** The detection's name in files. */
  public String detection() {
    return cases.get(0).plan().detection().name();
  }

  public String policy() {
    return cases.get(0).plan().policy();
  }

  /**
   * The metric by which policies are compared: the share of the first yardstick, else the score.
   */
  Metric metric() {
    return Yardstick.metric(cases);
  }

  /** The values of that metric, by scenario. */
  public Strata scores() {
    Metric metric = metric();
    return Strata.of(cases.stream().map(result -> result.figures(metric)).toList());
  }
}
