package org.hificamsim.reproduction.sensitivity;

import java.util.Locale;
import org.hificamsim.runs.Estimate;

/**
 * The conclusion of chapter 8 in one place: hi-fi proportion of the optimum less CamSim's.
 *
 * @param layout a layout, or {@code all} for the mean over the three
 * @param hifi NaN where the optimum is 0 throughout, and so for the others
 */
record Gap(
    ParameterSweep sweep,
    Variant variant,
    String layout,
    String policy,
    Estimate hifi,
    Estimate camsim,
    Estimate difference) {
  /** All layouts together. */
  static final String ALL = "all";

  /** What the gap says of the conclusion. */
  enum Finding {
    UNDERESTIMATES,
    OVERESTIMATES,
    OPEN;

    /** The name in files. */
    String label() {
      return name().toLowerCase(Locale.ROOT);
    }
  }

  boolean isOf(ParameterSweep other) {
    return sweep.parameter().equals(other.parameter());
  }

  boolean isAt(Variant other) {
    return variant.value().equals(other.value());
  }

  /** The place of the value in its sweep, from 0. */
  int place() {
    return sweep.variants().stream().map(Variant::value).toList().indexOf(variant.value());
  }

  /** CamSim's model underestimates, overestimates, or the 95% interval holds 0. */
  Finding finding() {
    if (difference.low() > 0) {
      return Finding.UNDERESTIMATES;
    }
    return difference.high() < 0 ? Finding.OVERESTIMATES : Finding.OPEN;
  }
}
