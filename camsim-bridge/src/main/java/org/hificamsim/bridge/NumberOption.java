package org.hificamsim.bridge;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.core.registry.Options;

/** Reads an option that is a number, or several of them between semicolons, commas or blanks. */
final class NumberOption {
  private static final int MAX_NUMBERS = 1000;

  private NumberOption() {}

  /** A number from {@code least} to {@code most}. */
  static double number(String key, String text, double least, double most) {
    return Options.parse("options", key + "=" + text).number(key, least, least, most, key);
  }

  /** A whole number from {@code least} to {@code most}. */
  static int integer(String key, String text, int least, int most) {
    return Options.parse("options", key + "=" + text).integer(key, least, least, most, key);
  }

  /**
   * Rising numbers from {@code least} to {@code most}, at least one.
   *
   * @param what they are, as in "radii"
   * @param example of such a list
   */
  static List<Double> rising(
      String key, String text, double least, double most, String what, String example) {
    List<Double> numbers = new ArrayList<>();
    for (String item : text.strip().split("[;,\\s]+")) {
      double number = number(key, item, least, most);
      if (!numbers.isEmpty() && number <= numbers.get(numbers.size() - 1)) {
        throw new InputException(
            "%s has '%s' after %s, expected rising %s, each once, such as %s"
                .formatted(key, item, numbers.get(numbers.size() - 1), what, example));
      }
      numbers.add(number);
    }
    if (numbers.size() > MAX_NUMBERS) {
      throw new InputException(
          "%s has %s %s, expected at most %s".formatted(key, numbers.size(), what, MAX_NUMBERS));
    }
    return numbers;
  }

  /** Refuses an option that has no effect without another. */
  static void requireFor(String key, Optional<String> value, boolean present, String needed) {
    if (value.isPresent() && !present) {
      throw new InputException(
          key + " is '" + value.get() + "' without " + needed + ", expected both");
    }
  }
}
