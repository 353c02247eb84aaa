package org.hificamsim.agents.temporal;

/**
 * The readings of Eq 7.5, the reward of an action, given the camera's utility before and after it.
 * The utility is the number of targets detected, or a share of another objective ({@link
 * org.hificamsim.agents.choice.Utility}).
 *
 * <p>As printed, the reward is lambda times the count U_i(O_i), where lambda is 1, 0 or -1 as the
 * count rises, stays or falls. Then losing all targets costs nothing, and regaining them pays: with
 * a discount above 0.2 cameras learn to oscillate. The change of the count has the same sign and
 * sums up to the discounted count; therefore it is the default.
 */
public enum RewardReading {
  /** The number detected after the action less the number before it. */
  COUNT_CHANGE,

  /** Only the lambda of Eq 7.5: 1, 0 or -1. */
  SIGN,

  /** Eq 7.5 as printed: lambda times the number detected after the action. */
  LITERAL;

  /** Returns the reward, in targets. */
  public double reward(double before, double after) {
    double change = after - before;
    return switch (this) {
      case COUNT_CHANGE -> change;
      case SIGN -> Math.signum(change);
      case LITERAL -> Math.signum(change) * after;
    };
  }
}
