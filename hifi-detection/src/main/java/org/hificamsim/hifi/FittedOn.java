package org.hificamsim.hifi;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.Arrays;

/**
 * What a model was fitted on, beyond which nobody has measured whether it holds.
 *
 * @param size q, metres
 * @param distance d, metres
 * @param focalLength z, metres
 * @param objects how many different ones
 * @param betweenObjects standard deviation of what one object's confidences have in common, about
 *     g; 0 where that is not known
 * @param withinObjects standard deviation of one object's confidences about what they have in
 *     common; 0 where that is not known
 */
public record FittedOn(
    @JsonProperty("q") Span size,
    @JsonProperty("d") Span distance,
    @JsonProperty("z") Span focalLength,
    int objects,
    double betweenObjects,
    double withinObjects) {
  /**
   * From the least to the greatest value that was there; of lengths, metres.
   *
   * @param most {@code least} or more
   */
  public record Span(double least, double most) {
    private static final double ROUNDING = 1e-9;

    /** Whether a value lies inside, but for rounding. */
    public boolean contains(double value) {
      return value >= least - ROUNDING * Math.abs(least)
          && value <= most + ROUNDING * Math.abs(most);
    }

    /** The span of some values. */
    public static Span of(double[] values) {
      return new Span(
          Arrays.stream(values).min().orElseThrow(), Arrays.stream(values).max().orElseThrow());
    }
  }
}
