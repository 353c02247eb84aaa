package org.hificamsim.runs;

/** Cuts the intervals of metrics to their possible values. */
final class MetricRange {
  private MetricRange() {}

  /** Cuts the interval of a mean over the runs of a plan. */
  static Estimate cut(Metric metric, RunPlan plan, Estimate mean) {
    return metric == Metric.REGRET
        ? mean
        : mean.within(0, Math.max(most(metric, plan), mean.mean()));
  }

  /** The greatest possible value; infinity if none is known. */
  private static double most(Metric metric, RunPlan plan) {
    double mostOfStep = plan.objective().isShare() ? 1 : Double.POSITIVE_INFINITY;
    return switch (metric) {
      case SCORE -> mostOfStep * plan.steps();
      case MEAN_SCORE -> mostOfStep;
      default -> isShare(metric) ? 1 : Double.POSITIVE_INFINITY;
    };
  }

  private static boolean isShare(Metric metric) {
    return metric != Metric.TRACKED
        && (metric.unit().startsWith("share") || metric.unit().equals("probability"));
  }
}
