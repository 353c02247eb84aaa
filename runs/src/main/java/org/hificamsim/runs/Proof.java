package org.hificamsim.runs;

import java.util.Optional;
import org.hificamsim.core.Texts;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.core.policy.ProvingZoomPolicy;
import org.hificamsim.core.policy.ZoomPolicy;

/**
 * How far a run's configurations are proven to be the best ones that its policy could take.
 *
 * @param unprovenSteps the number of steps whose search ended without a proof
 * @param gap what the score might gain in those steps at most
 */
public record Proof(long unprovenSteps, double gap) {
  /** Of no steps at all. */
  public static final Proof OF_NOTHING = new Proof(0, 0);

  /** What a policy proved; empty for one that does not claim to be the best. */
  public static Optional<Proof> of(ZoomPolicy policy) {
    return policy instanceof ProvingZoomPolicy proving && !proving.ofExpectation()
        ? Optional.of(new Proof(proving.unprovenSteps(), proving.gap()))
        : Optional.empty();
  }

  /**
   * Says what is not proven.
   *
   * @param steps how many there were
   */
  public String missing(long steps, Objective objective) {
    return Texts.format(
        "%s of %s steps; their %s might be up to %s higher in sum",
        unprovenSteps,
        steps,
        objective.stepScore(),
        gap == Math.rint(gap) ? Long.toString((long) gap) : Texts.format("%.3f", gap));
  }

  /** What is proven of these steps and of others. */
  public Proof plus(Proof other) {
    return new Proof(unprovenSteps + other.unprovenSteps, gap + other.gap);
  }
}
