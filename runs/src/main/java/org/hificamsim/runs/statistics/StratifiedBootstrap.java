package org.hificamsim.runs.statistics;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.function.ToDoubleBiFunction;
import org.hificamsim.runs.Estimate;

/**
 * The stratified percentile bootstrap: 95% intervals from drawing the seeds of each scenario again.
 * Same scores, same interval. There is none where no scenario has two runs.
 */
public final class StratifiedBootstrap {
  private static final int RESAMPLES = 2000;
  private static final long SEED = 2021;

  private StratifiedBootstrap() {}

  /** Several figures of the scores, each with its interval. */
  static Estimate[] all(Function<Strata, double[]> figures, Strata strata) {
    double[] values = figures.apply(strata);
    double[][] drawn = new double[values.length][strata.varies() ? RESAMPLES : 0];
    SplittableRandom random = new SplittableRandom(SEED);
    for (int i = 0; strata.varies() && i < RESAMPLES; i++) {
      double[] again = figures.apply(strata.drawn(random));
      for (int figure = 0; figure < values.length; figure++) {
        drawn[figure][i] = again[figure];
      }
    }
    Estimate[] estimates = new Estimate[values.length];
    Arrays.setAll(estimates, figure -> Estimate.drawn(values[figure], drawn[figure]));
    return estimates;
  }

  /** A figure of two policies' scores with its interval; each is drawn on its own. */
  static Estimate of(ToDoubleBiFunction<Strata, Strata> figure, Strata one, Strata other) {
    boolean varies = one.varies() || other.varies();
    SplittableRandom random = new SplittableRandom(SEED);
    double[] drawn = new double[varies ? RESAMPLES : 0];
    Arrays.setAll(drawn, i -> figure.applyAsDouble(one.drawn(random), other.drawn(random)));
    return Estimate.drawn(figure.applyAsDouble(one, other), drawn);
  }
}
