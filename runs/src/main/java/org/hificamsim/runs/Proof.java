package org.hificamsim.runs;

import java.util.Optional;
import org.hificamsim.core.Texts;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.ProvingZoomPolicy;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * The proof that a run's configurations are the best that its policy could choose, perhaps with
 * gaps.
 *
 * @param unprovenSteps the number of steps whose search ended without a proof
 * @param gap the most that the score could gain in those steps
 */
public record Proof(long unprovenSteps, double gap) {
  /** The proof of no steps. */
  public static final Proof NO_STEPS = new Proof(0, 0);

  /** The proof of a policy; empty if it does not claim to be the best. */
  public static Optional<Proof> of(ZoomPolicy policy) {
    return policy instanceof ProvingZoomPolicy proving && !proving.ofExpectation()
        ? Optional.of(new Proof(proving.unprovenSteps(), proving.gap()))
        : Optional.empty();
  }

  /**
   * Describes the steps that are not proven.
   *
   * @param steps the number of all steps
   */
  public String describeUnproven(long steps, Objective objective) {
    return Texts.format(
        "%s of %s steps; their %s might be up to %s higher in sum",
        unprovenSteps,
        steps,
        objective.stepScore(),
        gap == Math.rint(gap) ? Long.toString((long) gap) : Texts.format("%.3f", gap));
  }

  /** The proof of these steps and of others together. */
  public Proof plus(Proof other) {
    return new Proof(unprovenSteps + other.unprovenSteps, gap + other.gap);
  }
}
