package org.hificamsim.runs;

import java.util.Optional;
import org.hificamsim.core.channel.Channel;
import org.hificamsim.core.engine.NetworkSums;
import org.hificamsim.core.engine.RunCoverage;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.ProvingZoomPolicy;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * A repeat whose steps have been added up, with what its policy says of it: what {@link Metric
 * metrics} are computed from.
 *
 * @param traffic what the cameras sent each other
 * @param network what the cameras did together
 * @param proof what the policy proved; empty under one that does not claim to be the best
 * @param expectedGap what the least expected coverage might gain, over all steps; NaN where none is
 *     known
 * @param zones how much of them is seen as they ask
 */
public record Measured(
    RunCoverage coverage,
    Objective objective,
    Traffic traffic,
    NetworkSums network,
    Optional<Proof> proof,
    double expectedGap,
    Zones zones) {
  /** How much of the zones is met, all together and of the least one; NaN without zones. */
  public record Zones(double met, double least) {
    static final Zones NONE = new Zones(Double.NaN, Double.NaN);
  }

  /** A repeat under a policy. */
  static Measured of(
      RunCoverage coverage,
      Objective objective,
      ZoomPolicy policy,
      Channel channel,
      NetworkSums network,
      Zones zones) {
    double gap =
        policy instanceof ProvingZoomPolicy proving && proving.ofExpectation()
            ? proving.gap()
            : Double.NaN;
    Traffic traffic = Traffic.of(policy, channel).with(network);
    return new Measured(coverage, objective, traffic, network, Proof.of(policy), gap, zones);
  }

  /** A repeat that others ran. */
  public Measured(
      RunCoverage coverage, Objective objective, Traffic traffic, Optional<Proof> proof) {
    this(coverage, objective, traffic, NetworkSums.NONE, proof, Double.NaN, Zones.NONE);
  }

  /** The number of steps that are not proven; NaN without a claim. */
  double unprovenSteps() {
    return proof.isPresent() ? proof.get().unprovenSteps() : Double.NaN;
  }

  /** What the score could have been at most; NaN without a claim. */
  double bound() {
    return proof.isPresent() ? coverage.score() + proof.get().gap() : Double.NaN;
  }

  /** What the least expected coverage could have been at most; NaN without a claim. */
  double leastExpectedKBound() {
    return coverage.leastExpectedK() + expectedGap / Math.max(1, coverage.steps());
  }
}
