package org.hificamsim.profiling.fit;

import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.hifi.detector.DetectorModel;

/** Every shape of g by name, the simplest first. */
public final class DetectorShapes {
  private static final List<DetectorRegression> ALL =
      List.of(new Line(), new LogisticFit(), new SaturatingFit(), new HillFit(), new IsotonicFit());

  private DetectorShapes() {}

  /** All, the one with the fewest parameters first. */
  public static List<DetectorRegression> all() {
    return ALL;
  }

  /** Their names. */
  public static List<String> names() {
    return ALL.stream().map(DetectorRegression::name).toList();
  }

  /**
   * One.
   *
   * @throws InputException when there is none of this name
   */
  public static DetectorRegression of(String name) {
    return ALL.stream()
        .filter(one -> one.name().equals(name))
        .findFirst()
        .orElseThrow(
            () ->
                new InputException(
                    "g '%s' is unknown, expected one of %s"
                        .formatted(name, String.join(", ", names()))));
  }

  /** The thesis's line (Eqs 5.2 to 5.4). */
  static final class Line implements DetectorRegression {
    @Override
    public String name() {
      return "line";
    }

    @Override
    public DetectorModel fit(double[] pip, double[] confidence) {
      return LineFit.of(pip, confidence).line();
    }
  }
}
