package org.hificamsim.profiling.trial;

import org.hificamsim.profiling.measure.Measurement;

/**
 * One photo, and what the simulator makes of its camera and target by a model that has not seen the
 * object.
 *
 * @param measured whether the measured confidence reaches the threshold
 * @param simulated whether the simulator detects the target by that threshold
 * @param measuredByChance whether the confidence reaches the threshold of {@code --detect chance}
 * @param chance with which the simulator detects the target by {@code --detect chance}; NaN where
 *     the model has no scatter
 */
public record Trial(
    Measurement photo,
    boolean measured,
    boolean simulated,
    boolean measuredByChance,
    double chance) {
  /** Whether simulator and photo say the same. */
  public boolean agrees() {
    return measured == simulated;
  }

  /** Whether the detector found what the simulator does not. */
  public boolean missed() {
    return measured && !simulated;
  }

  /** Whether the simulator finds what the detector did not. */
  public boolean invented() {
    return simulated && !measured;
  }
}
