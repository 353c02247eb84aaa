package org.hificamsim.profiling.fit;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;

/**
 * Predicted chances of a detection, and whether each of these unseen photos was detected.
 *
 * @param chances the predicted chance of each photo, in [0, 1]
 * @param detected 1 for a photo whose measured confidence reaches the threshold, else 0
 */
public record Reliability(double[] chances, double[] detected) {
  /**
   * The least distance of a chance from 0 and from 1 in the loss, so that no photo makes it
   * infinite.
   */
  private static final double MIN_CHANCE = 1e-3;

  private static final int FIFTHS = 5;

  /**
   * The chances and detections of some photos.
   *
   * @param expected the mean of their chances
   * @param detected the share that is detected
   */
  public record Part(int count, double expected, double detected) {
    /** Returns the expected minus the detected share. */
    public double error() {
      return expected - detected;
    }
  }

  /** Returns the chances and detections of all photos. */
  public Part all() {
    return part(IntStream.range(0, chances.length).toArray());
  }

  /** Returns the fifths of the photos in order of their chances. */
  public List<Part> fifths() {
    int[] order =
        IntStream.range(0, chances.length)
            .boxed()
            .sorted(Comparator.comparingDouble(row -> chances[row]))
            .mapToInt(row -> row)
            .toArray();
    return IntStream.range(0, FIFTHS)
        .mapToObj(
            fifth ->
                part(
                    Arrays.copyOfRange(
                        order, fifth * order.length / FIFTHS, (fifth + 1) * order.length / FIFTHS)))
        .toList();
  }

  /** Returns a copy whose chances include false alarms at a rate. */
  public Reliability withFalseAlarms(double rate) {
    return new Reliability(
        Arrays.stream(chances).map(chance -> rate + chance * (1 - rate)).toArray(), detected);
  }

  /** Returns the largest absolute error of a fifth. */
  public double worstFifth() {
    return fifths().stream().mapToDouble(part -> Math.abs(part.error())).max().orElseThrow();
  }

  private Part part(int[] rows) {
    return new Part(
        rows.length,
        Arrays.stream(Groups.select(rows, chances)).average().orElse(Double.NaN),
        Arrays.stream(Groups.select(rows, detected)).average().orElse(Double.NaN));
  }

  /** Returns the mean negative logarithm of the chance of the outcome. */
  public double logLoss() {
    return IntStream.range(0, chances.length)
        .mapToDouble(row -> -StrictMath.log(chanceOfOutcome(row)))
        .average()
        .orElseThrow();
  }

  private double chanceOfOutcome(int row) {
    double chance = detected[row] > 0 ? chances[row] : 1 - chances[row];
    return Math.max(MIN_CHANCE, Math.min(1 - MIN_CHANCE, chance));
  }
}
