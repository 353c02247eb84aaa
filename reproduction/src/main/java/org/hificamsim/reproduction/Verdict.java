package org.hificamsim.reproduction;

import java.util.List;
import java.util.Locale;
import org.hificamsim.runs.Estimate;

/** Whether a published result is reproduced; the rules are in {@code docs/reproduction.md}. */
public enum Verdict {
  REPRODUCED,
  WITHIN_INTERVAL,
  NOT_REPRODUCED;

  /** The largest distance between our proportion and a published one that counts as the same. */
  public static final double TOLERANCE = 0.05;

  /** The margin for rounding errors, with which a distance of exactly 0.05 counts as the same. */
  private static final double ROUNDING = 1e-9;

  /** The name in files. */
  public String label() {
    return name().toLowerCase(Locale.ROOT).replace('_', ' ');
  }

  /**
   * The verdict on a number: reproduced if ours is at most 0.05 away; else within interval if the
   * published number is in our 95% interval; else not reproduced.
   */
  public static Verdict of(Estimate ours, double published) {
    if (isNear(ours.mean() - published)) {
      return REPRODUCED;
    }
    return ours.low() <= published && published <= ours.high() ? WITHIN_INTERVAL : NOT_REPRODUCED;
  }

  /** Whether a distance from a published number is at most 0.05. */
  static boolean isNear(double distance) {
    return Math.abs(distance) <= TOLERANCE + ROUNDING;
  }

  /**
   * The verdict on a statement, given margins that have to be above 0: reproduced if the 95%
   * interval of every margin is above 0; not reproduced if one is below 0; else within interval.
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
