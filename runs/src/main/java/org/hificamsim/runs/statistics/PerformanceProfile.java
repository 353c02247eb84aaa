package org.hificamsim.runs.statistics;

import java.util.Arrays;
import java.util.stream.IntStream;
import org.hificamsim.runs.Estimate;

/**
 * The share of runs whose score is tau or more, for tau from 0 to 1. At 1 it is the share of runs
 * that were optimal throughout.
 *
 * @param shares one per {@link #TAUS}
 */
public record PerformanceProfile(Estimate[] shares) {
  /** Tau, in hundredths. */
  public static final double[] TAUS =
      IntStream.rangeClosed(0, 100).mapToDouble(percent -> percent / 100.0).toArray();

  /** The profile with its intervals, point by point. */
  public static PerformanceProfile of(Strata strata) {
    return new PerformanceProfile(
        Arrays.stream(Bootstrap.all(PerformanceProfile::shares, strata))
            .map(share -> share.within(0, 1))
            .toArray(Estimate[]::new));
  }

  private static double[] shares(Strata strata) {
    double[] sorted = strata.sorted();
    double[] shares = new double[TAUS.length];
    int below = 0;
    for (int i = 0; i < TAUS.length; i++) {
      while (below < sorted.length && sorted[below] < TAUS[i]) {
        below++;
      }
      shares[i] = (sorted.length - below) / (double) sorted.length;
    }
    return shares;
  }
}
