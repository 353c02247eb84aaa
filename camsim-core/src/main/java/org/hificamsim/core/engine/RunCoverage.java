package org.hificamsim.core.engine;

import org.hificamsim.core.metrics.ExpectedCoverage;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;

/**
 * The coverage of a whole run, summed step by step (thesis 7.1, Eq 7.2; Figure 7.9), with the moves
 * of the cameras.
 */
public final class RunCoverage implements StepListener {
  private long steps;
  private long performance;
  private double score;
  private long targets;
  private long uncovered;
  private long coveredOnce;
  private long coveredMore;
  private double sumOfMeans;
  private long detections;
  private final CameraMoves moves = new CameraMoves();
  private boolean byChance;
  private double expectedPerformance;
  private double expectedUncovered;
  private double expectedOnce;
  private double expectedMore;
  private double sumOfExpectedMeans;
  private double sumOfLeastK;
  private double sumOfLeastChances;

  @Override
  public void stepped(OracleView network, StepCoverage coverage) {
    steps++;
    performance += coverage.kMin();
    score += coverage.score();
    targets += coverage.targets();
    uncovered += coverage.covered0();
    coveredOnce += coverage.covered1();
    coveredMore += coverage.coveredK();
    sumOfMeans += coverage.meanK();
    detections += coverage.detections();
    moves.add(network);
    if (coverage.byChance()) {
      byChance = true;
      add(coverage.expected());
    }
  }

  private void add(ExpectedCoverage expected) {
    expectedPerformance += expected.kMin();
    expectedUncovered += expected.covered0();
    expectedOnce += expected.covered1();
    expectedMore += expected.coveredK();
    sumOfExpectedMeans += expected.meanK();
    sumOfLeastK += expected.leastK();
    sumOfLeastChances += expected.leastChance();
  }

  /** The number of steps so far. */
  public long steps() {
    return steps;
  }

  /** The sum of k_min over the steps (Eq 7.2). */
  public long performance() {
    return performance;
  }

  /** The sum of the steps' scores: the performance under k_min. */
  public double score() {
    return score;
  }

  /** The mean of the steps' scores; 0 without steps. */
  public double meanScore() {
    return steps == 0 ? 0 : score() / steps;
  }

  /** The mean of k_min over the steps; 0 without steps. */
  public double meanKMin() {
    return steps == 0 ? 0 : (double) performance / steps;
  }

  /** The share of targets, over all steps, that no camera covered; 0 without targets. */
  public double proportion0() {
    return share(uncovered);
  }

  /** The share of targets that exactly one camera covered. */
  public double proportion1() {
    return share(coveredOnce);
  }

  /** The share of targets that two or more cameras covered. */
  public double proportionK() {
    return share(coveredMore);
  }

  /** The mean over the steps of the mean of k_j over the targets. */
  public double meanK() {
    return steps == 0 ? 0 : sumOfMeans / steps;
  }

  /** The number of detections: one for each camera, target and step. */
  public long detections() {
    return detections;
  }

  /** The moves of the cameras so far. */
  public CameraMoves moves() {
    return moves;
  }

  /** The performance expected before luck is drawn; NaN under a threshold. */
  public double expectedPerformance() {
    return byChance ? expectedPerformance : Double.NaN;
  }

  /** The expected share of targets, over all steps, that no camera covers. */
  public double expectedProportion0() {
    return expected(expectedUncovered, targets);
  }

  /** The expected share of targets that exactly one camera covers. */
  public double expectedProportion1() {
    return expected(expectedOnce, targets);
  }

  /** The expected share of targets that two or more cameras cover. */
  public double expectedProportionK() {
    return expected(expectedMore, targets);
  }

  /** The mean over the steps of the expected mean of k_j over the targets. */
  public double expectedMeanK() {
    return expected(sumOfExpectedMeans, steps);
  }

  /** The mean over the steps of the smallest of the expected k_j. */
  public double leastExpectedK() {
    return expected(sumOfLeastK, steps);
  }

  /** The mean over the steps of the least chance of a target to be covered. */
  public double leastChance() {
    return expected(sumOfLeastChances, steps);
  }

  private double expected(double sum, long count) {
    return !byChance ? Double.NaN : count == 0 ? 0 : sum / count;
  }

  private double share(long count) {
    return targets == 0 ? 0 : (double) count / targets;
  }
}
