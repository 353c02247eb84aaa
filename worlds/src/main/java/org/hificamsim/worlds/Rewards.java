package org.hificamsim.worlds;

import java.util.Arrays;
import java.util.function.ToDoubleFunction;
import org.hificamsim.agents.temporal.RewardReading;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.SeenPairs;
import org.hificamsim.core.registry.Options;
import org.hificamsim.core.registry.Registry;

/** Registers the rewards by name. */
public final class Rewards {
  private Rewards() {}

  /** The registry of all rewards. */
  public static Registry<Reward> registry() {
    return new Registry<Reward>("reward")
        .register(
            "coverage",
            "for all alike: the share of the targets that a camera detects, in [0, 1]",
            () -> team(Rewards::covered))
        .register("kmin", "for all alike: the least k of a target", () -> team(StepCoverage::kMin))
        .register(
            "score",
            "for all alike: what the scenario's objective scores",
            () -> team(StepCoverage::score))
        .register(
            "difference",
            "what the share covered would lose without the camera, in [0, 1]",
            Difference::new)
        .register("thesis", "Eq 7.5 of the targets that the camera detects", Thesis::from);
  }

  /** The share of the present targets that are covered; 0 if none is present. */
  static double covered(StepCoverage coverage) {
    return coverage.targets() == 0 ? 0 : 1 - (double) coverage.covered0() / coverage.targets();
  }

  private static Reward team(ToDoubleFunction<StepCoverage> score) {
    return (network, coverage, out) -> Arrays.fill(out, (float) score.applyAsDouble(coverage));
  }

  /** The difference reward of Wolpert and Tumer (2002): targets that only this camera detects. */
  private static final class Difference implements Reward {
    private final SeenPairs pairs = new SeenPairs();

    @Override
    public void pay(NetworkView network, StepCoverage coverage, float[] out) {
      Arrays.fill(out, 0);
      network.findSeen(pairs);
      for (int i = 0; i < pairs.count(); i++) {
        out[pairs.camera(i)] += network.coverage(pairs.target(i)) == 1 ? 1 : 0;
      }
      for (int camera = 0; camera < out.length; camera++) {
        out[camera] /= Math.max(1, coverage.targets());
      }
    }
  }

  /** The reward of the thesis's learners. */
  private static final class Thesis implements Reward {
    private final RewardReading reading;
    private float[] lastDetected = {};

    private Thesis(RewardReading reading) {
      this.reading = reading;
    }

    private static Reward from(Options options) {
      return new Thesis(
          options.choice(
              "reading", RewardReading.COUNT_CHANGE, "of Eq 7.5: count-change, sign, literal"));
    }

    @Override
    public void begin() {
      Arrays.fill(lastDetected, 0);
    }

    @Override
    public void pay(NetworkView network, StepCoverage coverage, float[] out) {
      lastDetected = lastDetected.length < out.length ? new float[out.length] : lastDetected;
      for (int camera = 0; camera < out.length; camera++) {
        int detected = network.detected(camera);
        out[camera] = (float) reading.reward(lastDetected[camera], detected);
        lastDetected[camera] = detected;
      }
    }
  }
}
