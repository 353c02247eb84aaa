package org.hificamsim.agents.temporal;

/**
 * What Eq 7.5 rewards an action with, given the camera's utility before and after it: the numbers
 * of targets detected, or its share of another objective ({@link
 * org.hificamsim.agents.choice.Utility}).
 *
 * <p>The equation prints lambda times the count U_i(O_i), with lambda being 1, 0 or -1 as the count
 * rises, stays or falls. Read so, losing every target costs nothing and regaining them pays: with a
 * discount above 0.2 it teaches cameras to oscillate. The change in count has the same sign and
 * sums up to the discounted count, which is why it is the default.
 */
public enum RewardReading {
  /** The number detected after less the number before. */
  COUNT_CHANGE,
  /** The lambda of Eq 7.5 alone: 1, 0 or -1. */
  SIGN,
  /** Eq 7.5 as printed: its lambda times the number detected after the action. */
  LITERAL;

  /** The reward, in targets. */
  public double reward(double before, double after) {
    double change = after - before;
    return switch (this) {
      case COUNT_CHANGE -> change;
      case SIGN -> Math.signum(change);
      case LITERAL -> Math.signum(change) * after;
    };
  }
}
