package org.hificamsim.core.scenario.spec;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.regex.Pattern;
import org.hificamsim.core.InputException;

/**
 * The number of detections that a camera can process in a step; the others are known a step late.
 * The attribute {@code processing} ({@code docs/following.md}).
 *
 * @param detections the number of detections, 1 or more
 */
public record ProcessingBudget(int detections) {
  /** The budget with which cameras process all that they detect. */
  public static final ProcessingBudget UNLIMITED = new ProcessingBudget(Integer.MAX_VALUE);

  private static final String NONE = "none";
  private static final Pattern NUMBER = Pattern.compile("[1-9]\\d{0,8}");

  /**
   * Parses {@code none} or a number of detections.
   *
   * @throws InputException if the text is neither
   */
  public static ProcessingBudget parse(String text) {
    if (text.equals(NONE)) {
      return UNLIMITED;
    }
    if (!NUMBER.matcher(text).matches()) {
      throw InputException.of(
          "%s is '%s', expected none or how many detections a camera processes in a step, 1 to"
              + " 999999999",
          setting("processing"), text);
    }
    return new ProcessingBudget(Integer.parseInt(text));
  }

  /** Whether cameras process all that they detect. */
  public boolean isUnlimited() {
    return detections == Integer.MAX_VALUE;
  }

  /** The budget as files have it. */
  public String text() {
    return isUnlimited() ? NONE : Integer.toString(detections);
  }
}
