package org.hificamsim.reproduction;

import java.util.List;
import java.util.Locale;
import org.hificamsim.runs.Estimate;

/** Whether something published is found again; the rules are in {@code docs/reproduction.md}. */
public enum Verdict {
  REPRODUCED,
  WITHIN_INTERVAL,
  NOT_REPRODUCED;

  /** How far from a published proportion ours may be to count as the same. */
  public static final double TOLERANCE = 0.05;

  /** Published numbers have two digits: half of the last one is no difference. */
  private static final double ROUNDING = 1e-9;

  /** The name in files. */
  public String label() {
    return name().toLowerCase(Locale.ROOT).replace('_', ' ');
  }

  /**
   * The verdict on a number: reproduced when ours is at most 0.05 away; within interval when the
   * published one lies in our 95% interval all the same; otherwise not.
   */
  public static Verdict of(Estimate ours, double published) {
    if (isNear(ours.mean() - published)) {
      return REPRODUCED;
    }
    return ours.low() <= published && published <= ours.high() ? WITHIN_INTERVAL : NOT_REPRODUCED;
  }

  /** Whether a distance from what is published is at most 0.05. */
  static boolean isNear(double distance) {
    return Math.abs(distance) <= TOLERANCE + ROUNDING;
  }

  /**
   * The verdict on a statement, as margins that it says are above 0: reproduced when each margin's
   * 95% interval is; not reproduced when one's interval is below 0; in between otherwise.
   */
  public static Verdict of(List<Estimate> margins) {
    if (margins.stream().allMatch(margin -> margin.low() > 0)) {
      return REPRODUCED;
    }
    return margins.stream().anyMatch(margin -> margin.high() < 0)
        ? NOT_REPRODUCED
        : WITHIN_INTERVAL;
  }
}
