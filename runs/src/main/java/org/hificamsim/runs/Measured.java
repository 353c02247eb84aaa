package org.hificamsim.runs;

import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.engine.EnergySums;
import org.hificamsim.core.engine.FollowingSums;
import org.hificamsim.core.engine.NetworkSums;
import org.hificamsim.core.engine.RunCoverage;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.BoundedZoomPolicy;
import org.hificamsim.core.policy.ProvingZoomPolicy;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * The sums over the steps of a repeat, from which {@link Metric metrics} are computed.
 *
 * @param traffic the traffic between the cameras
 * @param network the sums of the cameras' cooperation
 * @param energy the energy that the cameras took
 * @param proof the proof of the policy; empty if it does not claim to be the best
 * @param expectedGap the most that the least expected coverage could gain, summed over the steps;
 *     NaN if it is not known
 * @param zones the shares of the zones that are seen as they demand
 * @param following the measures of how the cameras followed targets
 * @param identitySwitches the identity switches of the policy; NaN if it makes none or they are not
 *     measured
 * @param reachableGap the most by which cameras whose moves take time could have exceeded the
 *     score; NaN if the policy does not bound it
 */
public record Measured(
    RunCoverage coverage,
    Objective objective,
    Traffic traffic,
    NetworkSums network,
    EnergySums energy,
    Optional<Proof> proof,
    double expectedGap,
    Zones zones,
    FollowingSums following,
    double identitySwitches,
    double reachableGap) {
  /**
   * The shares of zones that are seen as the zones demand.
   *
   * @param met the share over all zones; NaN without zones
   * @param least the share of the zone with the smallest share; NaN without zones
   * @param shares the share of each zone, by its name
   */
  public record Zones(double met, double least, Map<String, Double> shares) {
    static final Zones NONE = new Zones(Double.NaN, Double.NaN, Map.of());
  }

  /** The sums of a repeat under a policy. */
  static Measured of(RunMeters meters, RunPlan plan, ZoomPolicy policy, Simulation simulation) {
    double gap =
        policy instanceof ProvingZoomPolicy proving && proving.ofExpectation()
            ? proving.gap()
            : Double.NaN;
    NetworkSums network = simulation.cooperation().sums();
    Traffic traffic = Traffic.of(policy, simulation.network().channel()).with(network);
    return new Measured(
        meters.coverage(),
        plan.objective(),
        traffic,
        network,
        simulation.energy(),
        Proof.of(policy),
        gap,
        meters.zoneShares(),
        meters.followingSums(),
        meters.identitySwitches(policy),
        policy instanceof BoundedZoomPolicy bounded ? bounded.reachableGap() : Double.NaN);
  }

  /** Creates the sums of a repeat that another program ran. */
  public Measured(
      RunCoverage coverage,
      Objective objective,
      Traffic traffic,
      Optional<Proof> proof,
      FollowingSums following) {
    this(
        coverage,
        objective,
        traffic,
        NetworkSums.NONE,
        EnergySums.NONE,
        proof,
        Double.NaN,
        Zones.NONE,
        following,
        Double.NaN,
        Double.NaN);
  }

  /** The handovers as the network counts them; without a network, those of following. */
  double handovers() {
    double networkHandovers = network.counted(network.handovers());
    return Double.isNaN(networkHandovers) ? following.handovers() : networkHandovers;
  }

  /** The number of steps that are not proven; NaN if the policy claims nothing. */
  double unprovenSteps() {
    return proof.isPresent() ? proof.get().unprovenSteps() : Double.NaN;
  }

  /** The most that the score could have been; NaN if the policy claims nothing. */
  double bound() {
    return proof.isPresent() ? coverage.score() + proof.get().gap() : Double.NaN;
  }

  /** The most that cameras whose moves take time could have scored; NaN if not bounded. */
  double reachableBound() {
    return coverage.score() + reachableGap;
  }

  /**
   * The most that the least expected coverage could have been; NaN if the policy claims nothing.
   */
  double leastExpectedKBound() {
    return coverage.leastExpectedK() + expectedGap / Math.max(1, coverage.steps());
  }
}
