package org.hificamsim.profiling.fit;

import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.hifi.detector.DetectorModel;

/**
 * A shape of g and the way to fit it: an extension point; a line in {@link #ALL}.
 *
 * @param name the short name, as the model file's type says it
 * @param method fits confidences on PIP; the same for the same rows
 */
public record DetectorShape(String name, Method method) {
  /** Every shape, the one with the fewest parameters first. */
  public static final List<DetectorShape> ALL =
      List.of(
          new DetectorShape("line", (pip, y) -> LineFit.of(pip, y).line()), // Eqs 5.2 to 5.4
          new DetectorShape("logistic", CurveShapes::logistic),
          new DetectorShape("saturating-exponential", CurveShapes::saturating),
          new DetectorShape("hill", CurveShapes::hill),
          new DetectorShape("isotonic", IsotonicFit::fit));

  /** How a shape is fitted. */
  @FunctionalInterface
  public interface Method {
    /**
     * The fitted model.
     *
     * @param pip the share of the image of each row, [0, 1]
     * @param confidence what was measured of it
     * @throws InputException when there are fewer than three rows
     */
    DetectorModel fit(double[] pip, double[] confidence);
  }

  /** The names of all. */
  public static List<String> names() {
    return ALL.stream().map(DetectorShape::name).toList();
  }

  /**
   * One of them.
   *
   * @throws InputException when there is none of this name
   */
  public static DetectorShape of(String name) {
    return ALL.stream()
        .filter(one -> one.name().equals(name))
        .findFirst()
        .orElseThrow(
            () ->
                new InputException(
                    "g '%s' is unknown, expected one of %s"
                        .formatted(name, String.join(", ", names()))));
  }

  /** Fits it. */
  DetectorModel fit(double[] pip, double[] confidence) {
    return method.fit(pip, confidence);
  }
}
