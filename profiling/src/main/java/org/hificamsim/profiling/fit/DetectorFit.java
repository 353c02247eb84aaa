package org.hificamsim.profiling.fit;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.apache.commons.math3.util.MathArrays;

/**
 * What one detector's confidences say of PIP, measured or predicted by one f.
 *
 * @param shapes every shape of g, the simplest first
 * @param chosen the one that is taken
 * @param scatter about the chosen one
 * @param scatters about the chosen one, as they are drawn from: constant, growing
 * @param slope whether confidence rises at all
 */
public record DetectorFit(
    List<ShapeFit> shapes,
    ShapeFit chosen,
    ObjectScatter scatter,
    List<ScatterFit> scatters,
    RisingSlope slope) {
  /**
   * Fits every shape of g and chooses one.
   *
   * @param settings the shape that is wanted whatever fits best, and the seed of the bootstrap
   * @param objects the rows of each object
   * @param unseen what is left out together: objects, or folds where there is one object
   * @param x the PIP of each row
   * @param unseenX for each group the PIP of each row as an f says it that has not seen the group
   */
  static DetectorFit of(
      FitSettings settings,
      Groups objects,
      Groups unseen,
      double[] x,
      List<double[]> unseenX,
      double[] y) {
    List<ShapeFit> shapes =
        DetectorShape.ALL.stream().map(shape -> ShapeFit.of(shape, x, unseenX, y, unseen)).toList();
    ShapeFit chosen =
        settings
            .shape()
            .map(name -> shape(shapes, name))
            .orElseGet(
                () ->
                    shapes.get(
                        OneStandardError.simplest(
                            shapes.stream().map(ShapeFit::groupErrors).toList())));
    double[] fitted = Arrays.stream(x).map(chosen.g()::confidence).toArray();
    return new DetectorFit(
        shapes,
        chosen,
        ObjectScatter.of(MathArrays.ebeSubtract(y, fitted), objects),
        ScatterFit.both(chosen, y, unseen),
        RisingSlope.of(x, y, objects, settings.seed()));
  }

  private static ShapeFit shape(List<ShapeFit> shapes, String name) {
    return shapes.stream().filter(one -> one.shape().equals(name)).findFirst().orElseThrow();
  }

  /** The scatter that is taken: of the least log loss, the constant one where both are equal. */
  public ScatterFit drawnFrom() {
    return scatters.stream()
        .min(Comparator.comparingDouble(one -> one.calibration().logLoss()))
        .orElseThrow();
  }

  /** Whether this is no detector: nobody can be sure that a larger target is detected sooner. */
  public boolean refused() {
    return !slope.sure();
  }

  /**
   * How residuals scatter between objects and within one: a random effect of the object, by the
   * moments of a one-way analysis of variance.
   *
   * @param between standard deviation of the objects' own offsets; 0 where there is one object
   * @param within standard deviation about them
   */
  public record ObjectScatter(double between, double within) {
    /** Of residuals. */
    static ObjectScatter of(double[] residuals, Groups objects) {
      int rows = residuals.length;
      int count = objects.count();
      double grand = mean(residuals);
      double inside = 0;
      double outside = 0;
      double squares = 0;
      for (int[] object : objects.rows()) {
        double[] own = Groups.at(object, residuals);
        double mean = mean(own);
        inside += Arrays.stream(own).map(r -> (r - mean) * (r - mean)).sum();
        outside += own.length * (mean - grand) * (mean - grand);
        squares += (double) own.length * own.length;
      }
      double within = inside / Math.max(1, rows - count);
      double each = (rows - squares / rows) / Math.max(1, count - 1);
      double between = count > 1 ? (outside / (count - 1) - within) / each : 0;
      return new ObjectScatter(Math.sqrt(Math.max(0, between)), Math.sqrt(within));
    }

    private static double mean(double[] values) {
      return Arrays.stream(values).average().orElse(0);
    }
  }
}
