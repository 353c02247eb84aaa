package org.hificamsim.core.scenario.spec;

import java.util.regex.Matcher;
import java.util.regex.Pattern;

/**
 * The steps in which a camera is awake: the attribute {@code duty}, such as {@code 2/6@4}, which is
 * 2 of every 6 steps, beginning at step 4. Cameras with the same duty cycle are a cover set.
 *
 * @param awake the number of steps in which the camera is awake, 1 or more
 * @param period the number of steps after which it wakes up again
 * @param shift the step, below the period, in which it first wakes up
 */
public record DutyCycle(int awake, int period, int shift) {
  /** The expected form, for messages. */
  public static final String EXPECTED =
      "AWAKE/PERIOD or AWAKE/PERIOD@SHIFT in steps, such as 2/6@4: 1 to PERIOD steps awake, SHIFT"
          + " below PERIOD";

  private static final Pattern FORM = Pattern.compile("(\\d{1,9})/(\\d{1,9})(?:@(\\d{1,9}))?");

  /**
   * Parses a duty cycle.
   *
   * @throws IllegalArgumentException if the text is none
   */
  public static DutyCycle parse(String text) {
    Matcher matcher = FORM.matcher(text);
    if (!matcher.matches()) {
      throw new IllegalArgumentException(EXPECTED);
    }
    int shift = matcher.group(3) == null ? 0 : Integer.parseInt(matcher.group(3));
    DutyCycle duty =
        new DutyCycle(
            Integer.parseInt(matcher.group(1)), Integer.parseInt(matcher.group(2)), shift);
    if (duty.awake < 1 || duty.awake > duty.period || shift >= duty.period) {
      throw new IllegalArgumentException(EXPECTED);
    }
    return duty;
  }

  /** Whether the camera is awake in a step. */
  public boolean isAwake(long step) {
    return Math.floorMod(step - shift, period) < awake;
  }

  /** The duty cycle as files have it. */
  public String text() {
    return awake + "/" + period + (shift == 0 ? "" : "@" + shift);
  }
}
