package org.hificamsim.reproduction;

import java.util.Arrays;
import java.util.List;
import org.hificamsim.reproduction.Statement.Margin;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.compare.Bootstrap;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;

/** Differences between cases, paired by seed. */
final class Margins {
  private static final double LAST = 0.1;

  private final Cases cases;

  Margins(Cases cases) {
    this.cases = cases;
  }

  CaseResult hifi(String scenario, String policy) {
    return cases.find(scenario, ReproductionPlans.HIFI, policy);
  }

  CaseResult camsim(String scenario, String policy) {
    return cases.find(scenario, ReproductionPlans.CAMSIM, policy);
  }

  /** What one case has more of a figure than another. */
  static Margin more(String where, CaseResult one, CaseResult other, Metric metric) {
    return new Margin(where, Bootstrap.difference(one.figures(metric), other.figures(metric)));
  }

  /** How much higher one policy's k_min is than another's, in each of the six scenarios. */
  List<Margin> inAllSix(String better, String worse) {
    return inAllSix(better, worse, Metric.MEAN_K_MIN);
  }

  /** What one policy has more of a figure than another, in each of the six scenarios. */
  List<Margin> inAllSix(String more, String less, Metric metric) {
    return Layout.SCENARIOS.stream()
        .map(scenario -> more(scenario, hifi(scenario, more), hifi(scenario, less), metric))
        .toList();
  }

  /** What the distance between a proportion and the published one leaves of 0.05. */
  static Margin near(String where, Estimate ours, double published) {
    double off = Math.abs(ours.mean() - published);
    double slack = Verdict.TOLERANCE - off;
    double half = Math.max(ours.high() - ours.mean(), ours.mean() - ours.low());
    return new Margin(where, new Estimate(slack, slack - half, slack + half));
  }

  /** By how much less than 0.05 two cases' final proportions differ, either way. */
  static List<Margin> alike(String where, CaseResult one, CaseResult other, CaseResult optimum) {
    double[] difference = finalLevels(one);
    double[] others = finalLevels(other);
    double[] optima = finalLevels(optimum);
    Arrays.setAll(difference, i -> (difference[i] - others[i]) / optima[i]);
    double[] above = Arrays.stream(difference).map(d -> Verdict.TOLERANCE - d).toArray();
    double[] below = Arrays.stream(difference).map(d -> Verdict.TOLERANCE + d).toArray();
    return List.of(
        new Margin(where + ", above", Bootstrap.mean(above)),
        new Margin(where + ", below", Bootstrap.mean(below)));
  }

  /** The mean k_min over the last tenth, run by run. */
  static double[] finalLevels(CaseResult one) {
    return Arrays.stream(one.levels())
        .mapToDouble(
            levels ->
                Arrays.stream(levels)
                    .skip(levels.length - Math.max(1, Math.round(LAST * levels.length)))
                    .average()
                    .orElseThrow())
        .toArray();
  }
}
