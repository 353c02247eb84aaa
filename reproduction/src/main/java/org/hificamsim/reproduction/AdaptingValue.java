package org.hificamsim.reproduction;

import static org.hificamsim.reproduction.ReproductionPlans.CAMSIM;
import static org.hificamsim.reproduction.ReproductionPlans.FIXED;
import static org.hificamsim.reproduction.ReproductionPlans.HIFI;
import static org.hificamsim.reproduction.ReproductionPlans.OPTIMAL;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.Texts;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;

/**
 * The value of changing the zoom in a scenario: the exact optimum of every step compared with one
 * zoom level that all cameras keep.
 *
 * @param optimum the performance of the optimum, summed over the seeds
 * @param fixed the performance of {@code fixed:2}, summed over the seeds
 * @param sameEveryStep whether both have the same mean k_min in every step
 */
public record AdaptingValue(
    String scenario, String detection, long optimum, long fixed, boolean sameEveryStep) {
  /** The six scenarios under both models. */
  static List<AdaptingValue> of(Cases cases) {
    List<AdaptingValue> values = new ArrayList<>();
    for (String detection : List.of(HIFI, CAMSIM)) {
      for (String scenario : Layout.SCENARIOS) {
        values.add(of(cases, scenario, detection));
      }
    }
    return values;
  }

  /** The optimum over the fixed level; NaN if the fixed level covers nothing. */
  public double value() {
    return fixed == 0 ? Double.NaN : (double) optimum / fixed;
  }

  /** Describes the finding in a sentence. */
  public static String finding(List<AdaptingValue> values) {
    double most = values.stream().mapToDouble(AdaptingValue::value).max().orElse(Double.NaN);
    return Texts.format(
        "The optimum is static: %s has the k_min of optimal at every step in %d of %d"
            + " cases (scenario, model); at best, adapting the zoom is worth %.2f of a fixed"
            + " one.",
        FIXED, values.stream().filter(AdaptingValue::sameEveryStep).count(), values.size(), most);
  }

  private static AdaptingValue of(Cases cases, String scenario, String detection) {
    CaseResult optimal = cases.find(scenario, detection, OPTIMAL);
    CaseResult fixed = cases.find(scenario, detection, FIXED);
    return new AdaptingValue(
        scenario,
        detection,
        performance(optimal),
        performance(fixed),
        Arrays.equals(optimal.meanKMin(), fixed.meanKMin()));
  }

  private static long performance(CaseResult result) {
    return result.runs().stream().mapToLong(run -> (long) run.value(Metric.PERFORMANCE)).sum();
  }
}
