package org.hificamsim.runs;

import java.io.Serializable;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.engine.RunCoverage;
import org.hificamsim.core.policy.ExpectationProvingZoomPolicy;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * The coverage of one repeat.
 *
 * @param performance the sum of k_min over the steps (Eq 7.2)
 * @param meanKMin per step
 * @param covered0 share of targets that no camera covered, over all steps
 * @param covered1 share that exactly one camera covered
 * @param coveredK share that two or more cameras covered
 * @param meanK mean number of cameras that cover a target
 * @param detections one for each camera, target and step
 * @param zoomChanges how often a camera's view (its zoom level or pan angle) differed from that of
 *     the step before
 * @param messages sent between cameras
 * @param unprovenSteps steps whose configuration is not proven to be the best that the policy could
 *     take; -1 under a policy that does not claim it to be
 * @param gap what the score might gain in those steps at most
 * @param score the sum over the steps of what the objective makes of them; the performance by
 *     default
 * @param expected before luck was drawn, where detections are by chance
 */
public record RunResult(
    int run,
    long seed,
    long performance,
    double meanKMin,
    double covered0,
    double covered1,
    double coveredK,
    double meanK,
    long detections,
    long zoomChanges,
    long messages,
    long unprovenSteps,
    double gap,
    double score,
    ExpectedResult expected)
    implements Serializable {
  private static final Proof NO_CLAIM = new Proof(-1, 0);

  /** A result under k_min whose policy proves nothing. */
  public RunResult(
      int run,
      long seed,
      long performance,
      double meanKMin,
      double covered0,
      double covered1,
      double coveredK,
      double meanK,
      long detections,
      long zoomChanges,
      long messages) {
    this(
        run,
        seed,
        performance,
        meanKMin,
        covered0,
        covered1,
        coveredK,
        meanK,
        detections,
        zoomChanges,
        messages,
        NO_CLAIM.unprovenSteps(),
        NO_CLAIM.gap(),
        (double) performance,
        ExpectedResult.NONE);
  }

  /** What the policy proved; empty under one that does not claim to be the best. */
  public Optional<Proof> proof() {
    return unprovenSteps < 0 ? Optional.empty() : Optional.of(new Proof(unprovenSteps, gap));
  }

  /**
   * What the least expected coverage of a step might have been higher at most, in the mean; 0 where
   * that is proven to be the best, or where the policy does not claim it.
   */
  public double expectedGap() {
    double gap = expected.leastKBound() - expected.leastK();
    return gap > 0 ? gap : 0;
  }

  /** What is proven of several repeats together; of nothing where the policy claims nothing. */
  public static Proof proofOf(List<RunResult> results) {
    return results.stream()
        .flatMap(result -> result.proof().stream())
        .reduce(Proof.OF_NOTHING, Proof::plus);
  }

  /** The result of a repeat whose coverage has been added up, under a policy. */
  public static RunResult of(int run, long seed, RunCoverage coverage, ZoomPolicy policy) {
    double gap =
        policy instanceof ExpectationProvingZoomPolicy proving ? proving.gap() : Double.NaN;
    return of(run, seed, coverage, policy.messages(), Proof.of(policy))
        .with(ExpectedResult.of(coverage, gap));
  }

  /**
   * The result of a repeat whose coverage has been added up.
   *
   * @param proven what its policy proved; empty under one that does not claim to be the best
   */
  public static RunResult of(
      int run, long seed, RunCoverage coverage, long messages, Optional<Proof> proven) {
    Proof proof = proven.orElse(NO_CLAIM);
    return new RunResult(
        run,
        seed,
        coverage.performance(),
        coverage.meanKMin(),
        coverage.proportion0(),
        coverage.proportion1(),
        coverage.proportionK(),
        coverage.meanK(),
        coverage.detections(),
        coverage.zoomChanges(),
        messages,
        proof.unprovenSteps(),
        proof.gap(),
        coverage.score(),
        ExpectedResult.of(coverage, Double.NaN));
  }

  /** The same result as another repeat: a run with this seed may be any repeat of a plan. */
  public RunResult asRun(int repeat) {
    return copy(repeat, expected);
  }

  private RunResult with(ExpectedResult newExpected) {
    return copy(run, newExpected);
  }

  private RunResult copy(int newRun, ExpectedResult newExpected) {
    return new RunResult(
        newRun,
        seed,
        performance,
        meanKMin,
        covered0,
        covered1,
        coveredK,
        meanK,
        detections,
        zoomChanges,
        messages,
        unprovenSteps,
        gap,
        score,
        newExpected);
  }
}
