package org.hificamsim.tracks;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.PriorityQueue;

/**
 * Finds where targets jump: a way between two samples that is five times as fast as the slower of
 * the ways before and after it, and as three quarters of all ways. A car that drives on is fast and
 * does not jump.
 */
final class Jumps {
  private static final double ODD = 5;
  private static final double LEAST = 0.1; // m/s: of targets that all stand
  private static final int NAMED = 3; // jumps that are listed one by one

  /** A way that ends at a time. */
  record Leg(String target, double time, double way, double speed) {}

  private final Speeds speeds = new Speeds();
  private final PriorityQueue<Leg> fastest =
      new PriorityQueue<>(Comparator.comparingDouble(Leg::speed));
  private Leg before;
  private Leg now;

  /** Takes the next way of a track. */
  void add(Leg next) {
    judge(next);
    before = now;
    now = next;
  }

  /** The next way begins another track. */
  void endTrack() {
    judge(null);
    before = null;
    now = null;
  }

  private void judge(Leg next) {
    if (now != null && now.speed() > ODD * slower(next)) {
      speeds.add(now.speed());
      fastest.add(now);
      if (fastest.size() > NAMED) {
        fastest.poll();
      }
    }
  }

  private double slower(Leg next) {
    double earlier = before == null ? Double.POSITIVE_INFINITY : before.speed();
    double later = next == null ? Double.POSITIVE_INFINITY : next.speed();
    return before == null && next == null ? 0 : Math.min(earlier, later);
  }

  /**
   * The jumps in lines; none where there are none.
   *
   * @param thirdQuartile of all speeds, m/s
   */
  List<String> lines(double thirdQuartile) {
    double limit = ODD * Math.max(LEAST, Double.isNaN(thirdQuartile) ? 0 : thirdQuartile);
    long jumps = speeds.above(limit);
    List<String> lines = new ArrayList<>();
    if (jumps > 0) {
      lines.add(jumps + " jumps, faster than " + ImportSummary.rounded(limit) + " m/s");
      fastest.stream()
          .filter(leg -> leg.speed() > limit)
          .sorted(Comparator.comparingDouble(Leg::speed).reversed())
          .forEach(leg -> lines.add(line(leg)));
    }
    return lines;
  }

  private static String line(Leg leg) {
    return "target %s jumps %s m before %s s, %s m/s"
        .formatted(
            leg.target(),
            ImportSummary.rounded(leg.way()),
            ImportSummary.rounded(leg.time()),
            ImportSummary.rounded(leg.speed()));
  }

  /** How often each speed was, in steps of {@value #STEP} m/s, in bounded memory. */
  static final class Speeds {
    private static final double STEP = 0.01;
    private static final int BINS = 100_001; // up to 1,000 m/s; the last has the faster ones

    private final long[] counts = new long[BINS];
    private long count;

    void add(double metresPerSecond) {
      counts[(int) Math.min(BINS - 1, Math.rint(metresPerSecond / STEP))]++;
      count++;
    }

    /** The speed that this part of all is not above; NaN where there is none. */
    double quantile(double part) {
      long below = 0;
      for (int bin = 0; bin < BINS; bin++) {
        below += counts[bin];
        if (count > 0 && below >= part * count) {
          return bin * STEP;
        }
      }
      return Double.NaN;
    }

    /** How many were above a speed. */
    long above(double metresPerSecond) {
      long above = 0;
      for (int bin = BINS - 1; bin >= 0 && bin * STEP > metresPerSecond; bin--) {
        above += counts[bin];
      }
      return above;
    }
  }
}
