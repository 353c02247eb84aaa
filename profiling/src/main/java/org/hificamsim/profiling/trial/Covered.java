package org.hificamsim.profiling.trial;

/**
 * By how many cameras targets are covered, in the mean over many of them.
 *
 * @param once the share that one camera or more covers
 * @param more the share that two cameras or more cover
 * @param meanK the number of cameras that cover a target
 */
public record Covered(double once, double more, double meanK) {
  /** Adds up scenes. */
  static final class Sum {
    private double once;
    private double more;
    private double k;
    private int scenes;

    void add(double chanceOfOne, double chanceOfMore, double cameras) {
      once += chanceOfOne;
      more += chanceOfMore;
      k += cameras;
      scenes++;
    }

    void add(long cameras) {
      add(cameras >= 1 ? 1 : 0, cameras >= 2 ? 1 : 0, (double) cameras);
    }

    Covered mean() {
      return new Covered(once / scenes, more / scenes, k / scenes);
    }
  }
}
