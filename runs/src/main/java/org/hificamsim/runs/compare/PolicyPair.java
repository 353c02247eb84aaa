package org.hificamsim.runs.compare;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;

/** Two policies under one detection, over the same scenarios. */
record PolicyPair(PolicyScores one, PolicyScores other) {
  /**
   * The two in one scenario.
   *
   * @param metric whose differences are looked at
   */
  record InScenario(CaseResult one, CaseResult other, Metric metric) {
    /** What the first has more than the other, by seed, where both have a value. */
    double[] differences() {
      return Estimate.differences(one.figures(metric), other.figures(metric));
    }
  }

  /** Each pair once, the policy that was asked for first before the other. */
  static List<PolicyPair> of(List<PolicyScores> policies) {
    List<PolicyPair> pairs = new ArrayList<>();
    for (int i = 0; i < policies.size(); i++) {
      for (PolicyScores other : policies.subList(i + 1, policies.size())) {
        if (other.detection().equals(policies.get(i).detection())) {
          pairs.add(new PolicyPair(policies.get(i), other));
        }
      }
    }
    return pairs;
  }

  /** The pair scenario by scenario. */
  List<InScenario> inScenarios() {
    return IntStream.range(0, one.cases().size())
        .mapToObj(i -> new InScenario(one.cases().get(i), other.cases().get(i), one.metric()))
        .toList();
  }
}
