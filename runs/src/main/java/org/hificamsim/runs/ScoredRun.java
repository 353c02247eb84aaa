package org.hificamsim.runs;

/**
 * A run with the scores of the yardsticks of the same scenario, detection model and seed.
 *
 * @param optimum the score of the exact optimum of each step; NaN if it was not run
 * @param bound a bound that no score exceeds; NaN if it was not asked for
 * @param bestFixed the score of the best configuration that never changes; NaN if it was not run
 * @param reachable the interval of the best score of cameras whose moves take time; {@link
 *     Interval#UNKNOWN} if it was not asked for
 * @param settling the steps until the run is within 90% of its final level; NaN if that is 0
 */
public record ScoredRun(
    RunResult result,
    double optimum,
    double bound,
    double bestFixed,
    Interval reachable,
    double settling) {
  /**
   * An interval that has the greatest possible score in it.
   *
   * @param reached the score that a run reached
   * @param atMost a bound that no score exceeds
   */
  public record Interval(double reached, double atMost) {
    /** The interval of a score about which nothing is known. */
    public static final Interval UNKNOWN = new Interval(Double.NaN, Double.NaN);
  }

  /** Creates a run with an optimum and without bounds. */
  public ScoredRun(RunResult result, double optimum, double bestFixed, double settling) {
    this(result, optimum, Double.NaN, bestFixed, Interval.UNKNOWN, settling);
  }

  /**
   * Whether the run has a metric, perhaps without a value.
   *
   * @param isOptimum whether the run's policy is the optimum
   */
  public boolean has(Metric metric, boolean isOptimum) {
    return metric.isOfRun() ? result.has(metric) : metric.appliesTo(comparison(), isOptimum);
  }

  /** A metric's value; NaN if there is none. */
  public double value(Metric metric) {
    return metric.isOfRun() ? result.value(metric) : metric.valueFrom(comparison());
  }

  private ScoreComparison comparison() {
    return new ScoreComparison(
        result.score(), optimum, bound, bestFixed, reachable.atMost(), settling);
  }
}
