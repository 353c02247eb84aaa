package org.hificamsim.agents;

import org.hificamsim.agents.bandit.EpsilonGreedyZoomPolicy;
import org.hificamsim.agents.baseline.FixedZoomPolicy;
import org.hificamsim.agents.baseline.RandomZoomPolicy;
import org.hificamsim.agents.baseline.ZoomInPolicy;
import org.hificamsim.agents.baseline.ZoomOutPolicy;
import org.hificamsim.agents.optimal.OptimalZoomPolicy;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Registry;

/** The built-in zoom policies by name: the one place that knows them all. */
public final class CoveragePolicies {
  private CoveragePolicies() {}

  /** Adds every built-in policy to the registry and returns it. */
  public static Registry<ZoomPolicy> register(Registry<ZoomPolicy> registry) {
    return registry
        .register(ZoomOutPolicy.NAME, "every camera at its widest level", ZoomOutPolicy::new)
        .register(ZoomInPolicy.NAME, "every camera at its narrowest level", ZoomInPolicy::new)
        .register(
            FixedZoomPolicy.NAME, "given levels, one for all or one each", FixedZoomPolicy::from)
        .register(RandomZoomPolicy.NAME, "a uniformly drawn level each step", RandomZoomPolicy::new)
        .register(
            OptimalZoomPolicy.NAME,
            "the exactly best k_min of each step, with global knowledge",
            OptimalZoomPolicy::new)
        .register(
            EpsilonGreedyZoomPolicy.NAME,
            "bandit: the level with the best average count, sometimes another",
            EpsilonGreedyZoomPolicy::from);
  }
}
