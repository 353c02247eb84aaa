package org.hificamsim.runs;

import java.util.Optional;
import java.util.function.Function;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.InputException;
import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.detection.DetectionRule;

/**
 * A detection as users name it: {@code NAME} or {@code FILE.json}, or either with a threshold or a
 * rule of its own, {@code NAME@T}, {@code NAME@chance:alpha=0.01}.
 *
 * @param threshold the detection's own, in [0, 1]
 * @param rule the detection's own
 */
public record DetectionSpec(
    DetectionModel model, Optional<Double> threshold, Optional<DetectionRule> rule) {
  private static final Pattern WITH_THRESHOLD = Pattern.compile("(.+)@([-+.\\deE]+)");
  private static final Pattern WITH_RULE =
      Pattern.compile("(.+)@(" + String.join("|", DetectionRule.rules().names()) + ")(:[^@]*)?");

  /** Checks the threshold. */
  public DetectionSpec {
    threshold.ifPresent(Overrides::checkThreshold);
  }

  /**
   * Reads one.
   *
   * @param models finds a model by its name or file
   * @throws InputException when there is no such model, or its threshold or rule is wrong
   */
  public static DetectionSpec parse(String text, Function<String, DetectionModel> models) {
    Matcher parts = WITH_THRESHOLD.matcher(text);
    Matcher ruled = WITH_RULE.matcher(text);
    if (parts.matches()) {
      Optional<Double> own = Optional.of(number(parts.group(2)));
      return new DetectionSpec(models.apply(parts.group(1)), own, Optional.empty());
    }
    if (ruled.matches()) {
      String rule = text.substring(ruled.end(1) + 1).replace(';', ',');
      return new DetectionSpec(
          models.apply(ruled.group(1)), Optional.empty(), Optional.of(DetectionRule.parse(rule)));
    }
    return new DetectionSpec(models.apply(text), Optional.empty(), Optional.empty());
  }

  private static double number(String threshold) {
    try {
      return Double.parseDouble(threshold);
    } catch (NumberFormatException e) {
      throw new InputException(
          "threshold is '" + threshold + "', expected a number from 0 to 1", e);
    }
  }

  /**
   * The name in result files: the model's with its own threshold or, unless that is by a threshold,
   * with the rule; {@link #parse} understands it.
   */
  String name(DetectionRule used) {
    return used.certain()
        ? model.name() + threshold.map(value -> "@" + value).orElse("")
        : model.name() + "@" + used.text().replace(',', ';');
  }
}
