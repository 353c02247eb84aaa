package org.hificamsim.core.channel;

import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.core.InputException;
import org.hificamsim.core.registry.Options;

/**
 * The number of steps that a message takes from one camera to the next.
 *
 * @param text the delay as users write it
 * @param least the fewest steps of a uniform distribution
 * @param most the most steps of that distribution; equal to {@code least} for a constant delay
 * @param mean the mean of an exponential distribution, rounded to whole steps; 0 if the delay is
 *     not exponential
 */
record Delay(String text, int least, int most, double mean) {
  private static final int MAX = 10_000;
  private static final String WHOLE = "(\\d{1,5})";
  private static final Pattern STEPS = Pattern.compile(WHOLE + "(?:\\.\\." + WHOLE + ")?");
  private static final Pattern EXPONENTIAL =
      Pattern.compile("exponential:(\\d{1,5}(?:\\.\\d{1,9})?)");

  static Delay from(Options options) {
    return parse(
        options.text(
            "delay", "0", "steps to the next camera: 2, 1..5 (uniform), exponential:2 (mean)"));
  }

  private static Delay parse(String text) {
    Matcher steps = STEPS.matcher(text);
    Matcher exponential = EXPONENTIAL.matcher(text);
    if (steps.matches()) {
      int least = Integer.parseInt(steps.group(1));
      int most = steps.group(2) == null ? least : Integer.parseInt(steps.group(2));
      if (least <= most && most <= MAX) {
        return new Delay(text, least, most, 0);
      }
    } else if (exponential.matches() && Double.parseDouble(exponential.group(1)) <= MAX) {
      return new Delay(text, 0, 0, Double.parseDouble(exponential.group(1)));
    }
    throw InputException.of(
        "channel: delay is '%s', expected steps up to %s, as 2, 1..5 or exponential:2", text, MAX);
  }

  boolean isNone() {
    return most == 0 && mean == 0;
  }

  /**
   * Returns the delay for a random draw.
   *
   * @param draw a random number in [0, 1)
   */
  int steps(double draw) {
    return mean > 0
        ? (int) Math.rint(-mean * StrictMath.log1p(-draw))
        : least + (int) (draw * (most - least + 1));
  }
}
