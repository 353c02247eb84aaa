package org.hificamsim.runs.statistics;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.hificamsim.runs.Estimate;

/**
 * The bootstrap over seeds, for intervals of figures that are not means (Efron and Tibshirani, An
 * Introduction to the Bootstrap, 1993, chapter 13), {@linkplain Estimate#drawn corrected} for few
 * seeds. The same scores always give the same interval. A single seed gives none.
 */
public final class Bootstrap {
  private static final int DRAWS = 1000;
  private static final int DRAWS_OF_STRATA = 2000;
  private static final long SEED = 1993;
  private static final long SEED_OF_STRATA = 2021;

  private Bootstrap() {}

  /**
   * Estimates a figure of seeds. Draws for which the figure is NaN are omitted.
   *
   * @param seeds the number of seeds
   * @param figure the figure of some seeds, given by their numbers, which may repeat
   */
  public static Estimate of(int seeds, ToDoubleFunction<int[]> figure) {
    double value = figure.applyAsDouble(IntStream.range(0, seeds).toArray());
    SplittableRandom random = new SplittableRandom(SEED);
    double[] drawn = new double[seeds > 1 && !Double.isNaN(value) ? DRAWS : 0];
    int[] drawnSeeds = new int[seeds];
    for (int i = 0; i < drawn.length; i++) {
      Arrays.setAll(drawnSeeds, index -> random.nextInt(seeds));
      drawn[i] = figure.applyAsDouble(drawnSeeds);
    }
    return Estimate.drawn(value, Estimate.known(drawn), seeds, 1);
  }

  /** Estimates a figure of scores. Seeds are drawn within each scenario. */
  static Estimate of(ToDoubleFunction<Strata> figure, Strata strata) {
    SplittableRandom random = new SplittableRandom(SEED_OF_STRATA);
    double[] drawn = new double[strata.freedom() > 0 ? DRAWS_OF_STRATA : 0];
    Arrays.setAll(drawn, i -> figure.applyAsDouble(strata.drawn(random)));
    return Estimate.drawn(figure.applyAsDouble(strata), drawn, strata.runs(), strata.scenarios());
  }
}
