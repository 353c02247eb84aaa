package org.hificamsim.runs.statistics;

import java.util.Arrays;
import java.util.SplittableRandom;
import java.util.function.Function;
import java.util.function.ToDoubleBiFunction;
import java.util.function.ToDoubleFunction;
import java.util.stream.IntStream;
import org.hificamsim.runs.Estimate;

/**
 * The bootstrap over seeds, for intervals of figures that are not means (Efron and Tibshirani, An
 * Introduction to the Bootstrap, 1993, chapter 13), {@linkplain Estimate#drawn corrected} for few
 * seeds. The same scores have the same interval. A single seed has none.
 */
public final class Bootstrap {
  private static final int DRAWS = 1000;
  private static final int DRAWS_OF_STRATA = 2000;
  private static final long SEED = 1993;
  private static final long SEED_OF_STRATA = 2021;

  private Bootstrap() {}

  /**
   * The estimate of a figure of the seeds; draws for which it is NaN are left out.
   *
   * @param seeds the number of seeds
   * @param figure of some seeds, given by their numbers, which may repeat
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

  /** The estimates of several figures of scores; seeds are drawn within each scenario. */
  static Estimate[] all(Function<Strata, double[]> figures, Strata strata) {
    double[] values = figures.apply(strata);
    double[][] drawn = new double[values.length][strata.freedom() > 0 ? DRAWS_OF_STRATA : 0];
    SplittableRandom random = new SplittableRandom(SEED_OF_STRATA);
    for (int i = 0; strata.freedom() > 0 && i < DRAWS_OF_STRATA; i++) {
      double[] drawnValues = figures.apply(strata.drawn(random));
      for (int figure = 0; figure < values.length; figure++) {
        drawn[figure][i] = drawnValues[figure];
      }
    }
    Estimate[] estimates = new Estimate[values.length];
    Arrays.setAll(
        estimates,
        figure -> Estimate.drawn(values[figure], drawn[figure], strata.runs(), strata.scenarios()));
    return estimates;
  }

  /** The estimate of a figure of two policies' scores; each policy's seeds are drawn separately. */
  static Estimate of(ToDoubleBiFunction<Strata, Strata> figure, Strata policy, Strata other) {
    int freedom = policy.freedom() + other.freedom();
    SplittableRandom random = new SplittableRandom(SEED_OF_STRATA);
    double[] drawn = new double[freedom > 0 ? DRAWS_OF_STRATA : 0];
    Arrays.setAll(drawn, i -> figure.applyAsDouble(policy.drawn(random), other.drawn(random)));
    int seeds = policy.runs() + other.runs();
    return Estimate.drawn(figure.applyAsDouble(policy, other), drawn, seeds, seeds - freedom);
  }
}
