package org.hificamsim.profiling.fit;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.stat.regression.SimpleRegression;

/**
 * The slope of confidence on PIP by least squares, and whether it is significantly positive. There
 * are two 95% intervals: Student over the rows, and a bootstrap of whole objects, since rows of one
 * object share its texture.
 *
 * @param slope confidence per PIP
 * @param low the lower end of both intervals
 * @param high the upper end of both intervals
 * @param significant whether both intervals lie above 0, on PIP or on its logarithm; a confidence
 *     that rises early and then stays constant has hardly any slope on PIP
 */
public record RisingSlope(double slope, double low, double high, boolean significant) {
  private static final int DRAWS = 2000;
  private static final double LOWER = 2.5;
  private static final double UPPER = 97.5;
  private static final double LEAST_PIP = 1e-12;

  /** Computes the slope of a detector on PIP. */
  static RisingSlope of(double[] pip, double[] confidence, Groups objects, long seed) {
    double[] logarithms =
        Arrays.stream(pip).map(p -> StrictMath.log10(Math.max(LEAST_PIP, p))).toArray();
    RisingSlope onValues = onValues(pip, confidence, objects, seed);
    boolean significant =
        onValues.significant || onValues(logarithms, confidence, objects, seed).significant;
    return new RisingSlope(onValues.slope, onValues.low, onValues.high, significant);
  }

  /** Computes the slope of y on x; significant if both intervals for x itself lie above 0. */
  static RisingSlope onValues(double[] x, double[] y, Groups objects, long seed) {
    if (!FitScores.vary(x) || !FitScores.vary(y)) {
      return new RisingSlope(0, 0, 0, false);
    }
    Coefficient rows = LineFit.of(x, y).slope();
    double[] bootstrapSlopes =
        objects.count() > 1 ? bootstrapSlopes(x, y, objects, seed) : new double[] {rows.value()};
    double low = Math.min(rows.low(), StatUtils.percentile(bootstrapSlopes, LOWER));
    double high = Math.max(rows.high(), StatUtils.percentile(bootstrapSlopes, UPPER));
    return new RisingSlope(rows.value(), low, high, low > 0);
  }

  private static double[] bootstrapSlopes(double[] x, double[] y, Groups objects, long seed) {
    List<SimpleRegression> objectRegressions =
        objects.rows().stream().map(rows -> regression(rows, x, y)).toList();
    SplittableRandom random = new SplittableRandom(seed);
    return IntStream.range(0, DRAWS)
        .mapToDouble(
            draw -> {
              SimpleRegression sample = new SimpleRegression();
              objectRegressions.forEach(
                  unused ->
                      sample.append(
                          objectRegressions.get(random.nextInt(objectRegressions.size()))));
              return sample.getSlope();
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
