package org.hificamsim.profiling.trial;

import java.util.List;
import java.util.function.ToDoubleFunction;

/**
 * By how many cameras targets are covered, in the mean over many of them.
 *
 * @param once the share that one camera or more covers
 * @param more the share that two cameras or more cover
 * @param meanK the number of cameras that cover a target
 */
public record Covered(double once, double more, double meanK) {
  /** One target. */
  static Covered by(long cameras) {
    return new Covered(cameras >= 1 ? 1 : 0, cameras >= 2 ? 1 : 0, cameras);
  }

  /** The mean over many. */
  static Covered mean(List<Covered> all) {
    return new Covered(
        mean(all, Covered::once), mean(all, Covered::more), mean(all, Covered::meanK));
  }

  private static double mean(List<Covered> all, ToDoubleFunction<Covered> part) {
    return all.stream().mapToDouble(part).average().orElseThrow();
  }
}
