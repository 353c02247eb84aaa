package org.hificamsim.runs;

import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.DetectionModel;

/**
 * A detection as users name it: {@code NAME} or {@code FILE.json}, or either with a threshold of
 * its own, {@code NAME@T}.
 *
 * @param threshold the detection's own, in [0, 1]
 */
public record DetectionSpec(DetectionModel model, Optional<Double> threshold) {
  private static final Pattern WITH_THRESHOLD = Pattern.compile("(.+)@([-+.\\deE]+)");

  /** Checks the threshold. */
  public DetectionSpec {
    threshold.ifPresent(Overrides::checkThreshold);
  }

  /**
   * Reads one.
   *
   * @param models finds a model by its name or file
   * @throws InputException when there is no such model, or its threshold is not in [0, 1]
   */
  public static DetectionSpec parse(String text, Function<String, DetectionModel> models) {
    Matcher parts = WITH_THRESHOLD.matcher(text);
    return parts.matches()
        ? new DetectionSpec(models.apply(parts.group(1)), Optional.of(number(parts.group(2))))
        : new DetectionSpec(models.apply(text), Optional.empty());
  }

  private static double number(String threshold) {
    try {
      return Double.parseDouble(threshold);
    } catch (NumberFormatException e) {
      throw new InputException(
          "threshold is '" + threshold + "', expected a number from 0 to 1", e);
    }
  }

  /** The name in result files: the model's, and its own threshold where it has one. */
  public String name() {
    return model.name() + threshold.map(value -> "@" + value).orElse("");
  }
}
