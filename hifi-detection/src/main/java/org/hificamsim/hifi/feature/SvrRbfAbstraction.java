package org.hificamsim.hifi.feature;

import com.fasterxml.jackson.annotation.JsonProperty;
import com.fasterxml.jackson.annotation.JsonPropertyOrder;
import java.util.Arrays;

/**
 * Epsilon support vector regression with a radial basis function kernel (Eq 4.10, thesis 4.5.3):
 * {@code -log10(PIP) = intercept + sum of weight * exp(-gamma * |x - s|^2)} over the support
 * vectors s. Each variable is first scaled by its range.
 */
@JsonPropertyOrder({"gamma", "intercept", "ranges", "support"})
public final class SvrRbfAbstraction implements LogPipAbstraction {
  @JsonProperty private final double gamma;
  @JsonProperty private final double intercept;
  @JsonProperty private final Ranges ranges;
  @JsonProperty private final double[][] support;
  private final double[] scaled;

  /**
   * The range of a variable in the training data, by which it is scaled to [0, 1].
   *
   * @param least the value that is scaled to 0, in metres
   * @param most the value that is scaled to 1, in metres; above {@code least}
   */
  public record Range(double least, double most) {
    /** Returns the scaled value, which is outside [0, 1] beyond the training data. */
    public double scale(double value) {
      return (value - least) / (most - least);
    }
  }

  private record Ranges(Range q, Range d, Range z) {}

  /**
   * @param gamma width of the kernel, per scaled unit squared, above 0 (Eq 4.10's 1/(2 sigma^2))
   * @param intercept the constant term
   * @param support one row per support vector: q, d, z in metres, then its weight
   */
  public SvrRbfAbstraction(
      double gamma, double intercept, Range q, Range d, Range z, double[][] support) {
    this.gamma = gamma;
    this.intercept = intercept;
    this.ranges = new Ranges(q, d, z);
    this.support = Arrays.stream(support).map(double[]::clone).toArray(double[][]::new);
    this.scaled =
        Arrays.stream(support)
            .flatMapToDouble(
                row ->
                    Arrays.stream(
                        new double[] {q.scale(row[0]), d.scale(row[1]), z.scale(row[2]), row[3]}))
            .toArray();
  }

  @Override
  public double negativeLogPip(double size, double distance, double focalLength) {
    double x = ranges.q.scale(size);
    double y = ranges.d.scale(distance);
    double w = ranges.z.scale(focalLength);
    double sum = intercept;
    for (int i = 0; i < scaled.length; i += 4) {
      double dx = x - scaled[i];
      double dy = y - scaled[i + 1];
      double dw = w - scaled[i + 2];
      sum += scaled[i + 3] * StrictMath.exp(-gamma * (dx * dx + dy * dy + dw * dw));
    }
    return sum;
  }

  /** Returns the width of the kernel, per scaled unit squared. */
  public double gamma() {
    return gamma;
  }

  /** Returns a copy of the support vectors, one row each: q, d, z in metres, then the weight. */
  public double[][] support() {
    return Arrays.stream(support).map(double[]::clone).toArray(double[][]::new);
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof SvrRbfAbstraction that
        && Double.compare(gamma, that.gamma) == 0
        && Double.compare(intercept, that.intercept) == 0
        && ranges.equals(that.ranges)
        && Arrays.deepEquals(support, that.support);
  }

  @Override
  public int hashCode() {
    return Arrays.deepHashCode(support);
  }

  @Override
  public String toString() {
    return "svr-rbf with " + support.length + " support vectors, gamma " + gamma;
  }
}
