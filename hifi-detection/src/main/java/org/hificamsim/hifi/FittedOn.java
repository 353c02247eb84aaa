package org.hificamsim.hifi;

import com.fasterxml.jackson.annotation.JsonProperty;
import java.util.Arrays;

/**
 * The range of the data that a model was fitted on; outside it the model is untested.
 *
 * @param size q, in metres
 * @param distance d, in metres
 * @param focalLength z, in metres
 * @param objects the number of different objects
 * @param betweenObjects the standard deviation, over the objects, of an object's mean residual
 *     about g; 0 if unknown
 * @param withinObjects the standard deviation of an object's residuals about their mean; 0 if
 *     unknown
 */
public record FittedOn(
    @JsonProperty("q") Span size,
    @JsonProperty("d") Span distance,
    @JsonProperty("z") Span focalLength,
    int objects,
    double betweenObjects,
    double withinObjects) {
  /**
   * The range from the smallest to the largest value in the data, in metres.
   *
   * @param most the largest value, at least {@code least}
   */
  public record Span(double least, double most) {
    private static final double ROUNDING = 1e-9;

    /** Whether the span contains a value, with a tolerance for rounding. */
    public boolean contains(double value) {
      return value >= least - ROUNDING * Math.abs(least)
          && value <= most + ROUNDING * Math.abs(most);
    }

    /** Returns the span of one or more values. */
    public static Span of(double[] values) {
      return new Span(
          Arrays.stream(values).min().orElseThrow(), Arrays.stream(values).max().orElseThrow());
    }
  }
}
