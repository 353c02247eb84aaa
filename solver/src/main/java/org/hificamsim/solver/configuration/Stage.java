package org.hificamsim.solver.configuration;

import java.util.List;
import org.hificamsim.core.metrics.Objective;

/**
 * One of the values by which an objective compares configurations, in their order: how much of it
 * is {@linkplain Requirement required}, and whether the {@link RemainingSets} can still reach it.
 * Three upper bounds, each in a class of its own, show that and remove sets with which it is out of
 * reach: {@link SumRange}, {@link GainBound} and {@link Prices}.
 */
final class Stage {
  private final RemainingSets remaining;
  private final Requirement requirement;
  private final SumRange range;
  private final GainBound gains;
  private final Prices prices;
  private final TargetWorth trialWorth;

  private Stage(
      CoverageProblem problem,
      RemainingSets remaining,
      Requirement requirement,
      TargetWorth trialWorth) {
    this.remaining = remaining;
    this.requirement = requirement;
    this.trialWorth = trialWorth;
    range = new SumRange(problem, remaining, requirement.worth());
    gains = new GainBound(problem, remaining, requirement.worth());
    prices = new Prices(problem, remaining);
  }

  /** The stages of an objective. */
  static Stage[] stages(Objective objective, CoverageProblem problem, RemainingSets remaining) {
    return stages(objective, problem, remaining, false);
  }

  /** The only stage of the least k of the targets that some set has. */
  static Stage ofLeastCoverable(CoverageProblem problem, RemainingSets remaining) {
    return stages(Objective.kMin(), problem, remaining, true)[0];
  }

  private static Stage[] stages(
      Objective objective,
      CoverageProblem problem,
      RemainingSets remaining,
      boolean coverableOnly) {
    double maxTerms =
        LocalSearch.MAX_WEIGHT * (problem.maxCameras() + 2.0) * (problem.maxTargets() + 1);
    List<long[]> worths = objective.worths(problem.maxCameras(), problem.maxTargets());
    return worths.stream()
        .map(
            table ->
                new Stage(
                    problem,
                    remaining,
                    new Requirement(
                        problem,
                        remaining,
                        new TargetWorth(table, maxTerms),
                        objective.byLeast(),
                        coverableOnly),
                    new TargetWorth(table, maxTerms)))
        .toArray(Stage[]::new);
  }

  /** Forgets the prices of the last problem. */
  void reset() {
    prices.reset();
  }

  /** Requires this value or a greater one from now on, in place of what was required before. */
  void require(long value) {
    requirement.require(value);
  }

  /** The least difference between two values. */
  long step() {
    return requirement.step();
  }

  /** A value in units of what the objective counts as 1. */
  long inUnits(long value) {
    return value / requirement.step();
  }

  /** The worth of a target, as far as it counts towards what is required. */
  TargetWorth worth() {
    return requirement.worth();
  }

  /** The value of a configuration with this coverage, by target. */
  long value(int[] coverage) {
    return requirement.value(coverage);
  }

  /** Whether a configuration with this coverage has the value required. */
  boolean isReachedBy(int[] coverage) {
    return requirement.isMetBy(coverage);
  }

  /**
   * Removes sets with which the requirement is out of reach, by the range of the sum and by prices.
   *
   * @return whether the requirement is still in reach
   */
  boolean narrowByRange() {
    range.update();
    return surplus() >= 0
        && range.removeSetsWithoutIndispensable(surplus())
        && (!prices.areTuned() || prices.removeCheapSets(requirement.worth(), requirement.sum()));
  }

  /**
   * Removes sets with which the requirement is out of reach, by gains.
   *
   * @return whether the requirement is still in reach
   */
  boolean narrowByGains() {
    range.update();
    long gainSurplus = range.min() + gains.update() - requirement.sum();
    return gainSurplus >= 0 && gains.removeSetsBelow(gainSurplus);
  }

  /** Whether the last narrowing found that any choice meets the requirement. */
  boolean isMetInAnyCase() {
    return range.min() >= requirement.sum();
  }

  private long surplus() {
    return range.max() - requirement.sum();
  }

  /** The most that a set can gain, as of the last {@link #narrowByGains}. */
  long gain(int set) {
    return gains.gain(set);
  }

  /** The most that a set of an open camera gains, as of the last {@link #narrowByGains}. */
  long greatestGain(int camera) {
    return gains.greatestGain(camera);
  }

  /** Whether the target's worth still depends on what is chosen. */
  boolean isOpen(int target) {
    TargetWorth worth = requirement.worth();
    return worth.value(remaining.maxCoverage(target)) > worth.value(remaining.minCoverage(target));
  }

  /**
   * The number of further cameras that must cover a target, beyond those that do in any case, as of
   * the last narrowing; 0 when the requirement is in reach without them.
   */
  int camerasNeeded(int target) {
    return range.camerasNeeded(target, surplus());
  }

  /** An upper bound of the value that the remaining sets can reach, by range and prices. */
  long bound() {
    return requirement.byLeast() ? leastBound() : sumBound();
  }

  private long sumBound() {
    range.update();
    return prices.areTuned()
        ? Math.min(range.max(), prices.bound(requirement.worth()))
        : range.max();
  }

  private long leastBound() {
    int bound = (int) requirement.value(remaining.maxCoverage());
    while (prices.areTuned() && !pricesAllowLeast(bound)) {
      bound--;
    }
    return bound;
  }

  private boolean pricesAllowLeast(int least) {
    trialWorth.cut(least);
    return prices.bound(trialWorth) >= requirement.sumForLeast(least, trialWorth);
  }

  /**
   * Looks for prices that show that the requirement is out of reach.
   *
   * @param rounds how often prices are changed
   * @return whether the requirement is still in reach
   */
  boolean tunePrices(int rounds) {
    return prices.tune(requirement.worth(), requirement.sum(), rounds);
  }

  /** The lowest bound of the sum that the last {@link #tunePrices} found. */
  long lowestPriceBound() {
    return prices.lowestBound();
  }
}
