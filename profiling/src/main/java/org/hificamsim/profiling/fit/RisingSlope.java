package org.hificamsim.profiling.fit;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.stat.regression.SimpleRegression;

/**
 * Whether confidence surely rises with PIP: the slope of the least squares line and its 95%
 * intervals, by Student over the rows, and by a bootstrap that draws whole objects, since rows of
 * one object share its texture.
 *
 * @param slope confidence per PIP
 * @param low lower end of the wider one of the two intervals
 * @param high its upper end
 * @param sure whether both intervals lie above 0, on PIP or on its logarithm: what rises at once
 *     and then no more has next to no slope on PIP
 */
public record RisingSlope(double slope, double low, double high, boolean sure) {
  private static final int DRAWS = 2000;
  private static final double LOWER = 2.5;
  private static final double UPPER = 97.5;
  private static final double SMALLEST = 1e-12;

  /** Of one detector on one PIP. */
  static RisingSlope of(double[] pip, double[] confidence, Groups objects, long seed) {
    double[] logarithms =
        Arrays.stream(pip).map(p -> StrictMath.log10(Math.max(SMALLEST, p))).toArray();
    RisingSlope plain = plain(pip, confidence, objects, seed);
    boolean sure = plain.sure || plain(logarithms, confidence, objects, seed).sure;
    return new RisingSlope(plain.slope, plain.low, plain.high, sure);
  }

  /** Of y on x, sure where it surely rises with x itself. */
  static RisingSlope plain(double[] x, double[] y, Groups objects, long seed) {
    if (!FitScores.vary(x) || !FitScores.vary(y)) {
      return new RisingSlope(0, 0, 0, false);
    }
    Coefficient rows = LineFit.of(x, y).slope();
    double[] drawn = objects.count() > 1 ? drawn(x, y, objects, seed) : new double[] {rows.value()};
    double low = Math.min(rows.low(), StatUtils.percentile(drawn, LOWER));
    double high = Math.max(rows.high(), StatUtils.percentile(drawn, UPPER));
    return new RisingSlope(rows.value(), low, high, low > 0);
  }

  private static double[] drawn(double[] x, double[] y, Groups objects, long seed) {
    List<SimpleRegression> each =
        objects.rows().stream().map(rows -> regression(rows, x, y)).toList();
    SplittableRandom random = new SplittableRandom(seed);
    return IntStream.range(0, DRAWS)
        .mapToDouble(
            draw -> {
              SimpleRegression all = new SimpleRegression();
              each.forEach(any -> all.append(each.get(random.nextInt(each.size()))));
              return all.getSlope();
            })
        .filter(Double::isFinite)
        .toArray();
  }

  private static SimpleRegression regression(int[] rows, double[] x, double[] y) {
    SimpleRegression regression = new SimpleRegression();
    for (int row : rows) {
      regression.addData(x[row], y[row]);
    }
    return regression;
  }
}
