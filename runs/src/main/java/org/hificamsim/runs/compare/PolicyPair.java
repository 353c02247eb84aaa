package org.hificamsim.runs.compare;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;

/** Two policies under the same detection and in the same scenarios. */
record PolicyPair(PolicyScores first, PolicyScores second) {
  /** The comparison of both policies in one scenario by a metric. */
  record InScenario(CaseResult first, CaseResult second, Metric metric) {
    /** The first value minus the second, for each seed that has both. */
    double[] differences() {
      return Estimate.differences(first.figures(metric), second.figures(metric));
    }
  }

  /** The pairs under the same detection that are compared, in the order of the policies. */
  static List<PolicyPair> of(List<PolicyScores> policies, ReferencePolicy reference) {
    List<PolicyPair> pairs = new ArrayList<>();
    for (int i = 0; i < policies.size(); i++) {
      for (int other = 0; other < policies.size(); other++) {
        PolicyPair pair = new PolicyPair(policies.get(i), policies.get(other));
        boolean isCompared =
            reference.isAll()
                ? i < other
                : i != other && reference.policy().equals(pair.second.policy());
        if (isCompared && pair.second.detection().equals(pair.first.detection())) {
          pairs.add(pair);
        }
      }
    }
    return pairs;
  }

  /** The pair in each scenario. */
  List<InScenario> inScenarios() {
    return IntStream.range(0, first.cases().size())
        .mapToObj(i -> new InScenario(first.cases().get(i), second.cases().get(i), first.metric()))
        .toList();
  }
}
