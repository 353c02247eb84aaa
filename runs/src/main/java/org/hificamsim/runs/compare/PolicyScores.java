package org.hificamsim.runs.compare;

import java.util.List;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.statistics.Strata;

/**
 * A policy under a detection, over all scenarios.
 *
 * @param cases one per scenario
 */
public record PolicyScores(List<CaseResult> cases) {
  /** The policies of cases, in the order of their first appearance. */
  public static List<PolicyScores> of(List<CaseResult> cases) {
    return Cases.by(cases, one -> List.of(one.plan().detection().name(), one.plan().policy()))
        .values()
        .stream()
        .map(PolicyScores::new)
        .toList();
  }

  /** The detection's name in files. */
  public String detection() {
    return cases.get(0).plan().detection().name();
  }

  public String policy() {
    return cases.get(0).plan().policy();
  }

  /** What policies are compared by: their share of the leading yardstick, else the score. */
  Metric metric() {
    return Yardstick.metric(cases);
  }

  /** The same figures, by scenario. */
  public Strata scores() {
    Metric metric = metric();
    return Strata.of(cases.stream().map(one -> one.figures(metric)).toList());
  }
}
