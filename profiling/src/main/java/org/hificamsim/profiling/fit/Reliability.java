package org.hificamsim.profiling.fit;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * How chances of a detection do on photos that nothing behind the chances has seen.
 *
 * @param chances of each photo, in [0, 1]
 * @param detected 1 for a photo whose measured confidence reaches the threshold, else 0
 */
public record Reliability(double[] chances, double[] detected) {
  /** A chance nearer to 0 or 1 counts as this near: one photo does not make a loss infinite. */
  private static final double NEAREST = 1e-3;

  private static final int PARTS = 5;

  /**
   * Some photos.
   *
   * @param expected the mean of their chances
   * @param detected the share that is detected
   */
  public record Part(int photos, double expected, double detected) {
    /** How much too many are expected, a share. */
    public double error() {
      return expected - detected;
    }
  }

  /** All photos. */
  public Part all() {
    return part(IntStream.range(0, chances.length).toArray());
  }

  /** The fifths of the photos in order of their chances. */
  public List<Part> fifths() {
    int[] order =
        IntStream.range(0, chances.length)
            .boxed()
            .sorted(Comparator.comparingDouble(row -> chances[row]))
            .mapToInt(row -> row)
            .toArray();
    return IntStream.range(0, PARTS)
        .mapToObj(
            k ->
                part(
                    Arrays.copyOfRange(
                        order, k * order.length / PARTS, (k + 1) * order.length / PARTS)))
        .toList();
  }

  /** The same with false alarms among the detections that are expected. */
  public Reliability withFalseAlarms(double rate) {
    return new Reliability(
        Arrays.stream(chances).map(chance -> rate + chance * (1 - rate)).toArray(), detected);
  }

  /** The greatest error of a fifth, whatever its sign. */
  public double worstFifth() {
    return fifths().stream().mapToDouble(part -> Math.abs(part.error())).max().orElseThrow();
  }

  private Part part(int[] rows) {
    return new Part(
        rows.length,
        Arrays.stream(Groups.at(rows, chances)).average().orElse(Double.NaN),
        Arrays.stream(Groups.at(rows, detected)).average().orElse(Double.NaN));
  }

  /** The mean of -ln of the chance of what happened. */
  public double logLoss() {
    return IntStream.range(0, chances.length)
        .mapToDouble(row -> -StrictMath.log(ofWhatHappened(row)))
        .average()
        .orElseThrow();
  }

  private double ofWhatHappened(int row) {
    double chance = detected[row] > 0 ? chances[row] : 1 - chances[row];
    return Math.max(NEAREST, Math.min(1 - NEAREST, chance));
  }
}
