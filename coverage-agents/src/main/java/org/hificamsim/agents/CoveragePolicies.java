package org.hificamsim.agents;

import org.hificamsim.agents.bandit.EpsilonGreedyZoomPolicy;
import org.hificamsim.agents.bandit.SoftmaxZoomPolicy;
import org.hificamsim.agents.bandit.Ucb1ZoomPolicy;
import org.hificamsim.agents.baseline.AheadZoomPolicy;
import org.hificamsim.agents.baseline.FixedZoomPolicy;
import org.hificamsim.agents.baseline.IndependentGreedyZoomPolicy;
import org.hificamsim.agents.baseline.PatrolZoomPolicy;
import org.hificamsim.agents.baseline.RandomZoomPolicy;
import org.hificamsim.agents.baseline.TrackerZoomPolicy;
import org.hificamsim.agents.cooperative.CooperativeZoomPolicy;
import org.hificamsim.agents.optimal.BestFixedZoomPolicy;
import org.hificamsim.agents.optimal.OneHopZoomPolicy;
import org.hificamsim.agents.optimal.OptimalExpectedZoomPolicy;
import org.hificamsim.agents.optimal.OptimalZoomPolicy;
import org.hificamsim.agents.optimal.ReachableZoomPolicy;
import org.hificamsim.agents.temporal.TemporalDifferenceZoomPolicy;
import org.hificamsim.agents.voting.QbSarsaZoomPolicy;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;

/** The built-in zoom policies by name: the one place that knows them all. */
public final class CoveragePolicies {
  private CoveragePolicies() {}

  /** Adds every built-in policy to the registry and returns it. */
  public static Registry<ZoomPolicy> register(Registry<ZoomPolicy> registry) {
    return registry
        .register(
            "zoom-out",
            "every camera ahead at its widest zoom level",
            () -> new AheadZoomPolicy("zoom-out", PatrolZoomPolicy.Zoom.WIDEST))
        .register(
            "zoom-in",
            "every camera ahead at its narrowest zoom level",
            () -> new AheadZoomPolicy("zoom-in", PatrolZoomPolicy.Zoom.NARROWEST))
        .register("fixed", "given views, one for all or one each", FixedZoomPolicy::new)
        .register("random", "a uniformly drawn view each step", RandomZoomPolicy::new)
        .register("patrol", "sweeps over the pan angles, back and forth", PatrolZoomPolicy::new)
        .register(
            "tracker",
            "keeps the nearest target that it sees in the middle of its picture",
            TrackerZoomPolicy::new)
        .register(
            "independent-greedy",
            "each camera's view with most targets now, whatever others see",
            IndependentGreedyZoomPolicy::new)
        .alias("greedy", "independent-greedy") // its name up to 0.1; not the thesis's greedy
        .register(
            "optimal",
            "the best score of each step (k_min by default), exactly",
            OptimalZoomPolicy::new)
        .register(
            "bound",
            "a good configuration and a bound on the best score of each step, without a search",
            OptimalZoomPolicy::bound)
        .register(
            "optimal-expected",
            "the exactly best least expected coverage of each step, before luck is drawn",
            OptimalExpectedZoomPolicy::new)
        .register(
            "one-hop",
            "the best score that cameras reach within the step, exactly",
            OneHopZoomPolicy::new)
        .register(
            "best-fixed",
            "the best constant configuration of the very run, in hindsight",
            BestFixedZoomPolicy::new)
        .register(
            "reachable",
            "the best that is known of what cameras could reach in time, in hindsight, with a"
                + " bound",
            ReachableZoomPolicy::new)
        .register(
            "epsilon-greedy",
            "bandit: the view with the best average count, sometimes another",
            EpsilonGreedyZoomPolicy::new)
        .register(
            "ucb1", "bandit: the view with the best upper confidence bound", Ucb1ZoomPolicy::new)
        .register(
            "softmax",
            "bandit: views drawn the more often, the better their average count",
            SoftmaxZoomPolicy::new)
        .register(
            "sarsa",
            "on-policy temporal-difference learning of each camera on its own",
            TemporalDifferenceZoomPolicy::sarsa)
        .register(
            "q-learning",
            "off-policy temporal-difference learning of each camera on its own",
            TemporalDifferenceZoomPolicy::qLearning)
        .register(
            "qb-sarsa",
            "SARSA that follows the majority vote of the nearest cameras",
            QbSarsaZoomPolicy::new)
        .register(
            "cooperative",
            "cameras that share what they see, predict where targets go, and divide them up",
            CooperativeZoomPolicy::new);
  }
}
