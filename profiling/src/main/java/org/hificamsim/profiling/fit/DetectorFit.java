package org.hificamsim.profiling.fit;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.apache.commons.math3.util.MathArrays;

/**
 * Fits of one detector's confidences to PIP, measured or predicted by one f.
 *
 * @param shapes the fit of every shape of g, the simplest first
 * @param chosen the fit that is used
 * @param scatter the scatter about the chosen fit, between and within objects
 * @param scatters the models of the scatter about the chosen fit: constant, growing
 * @param slope whether confidence rises with PIP
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
   * @param settings the shape of g, if it is prescribed, and the seed of the bootstrap
   * @param objects the rows of each object
   * @param unseen the groups that are left out: objects, or folds if there is one object
   * @param x the PIP of each row
   * @param unseenX for each group, the PIP of each row as predicted by an f fitted without the
   *     group
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
        ScatterFit.constantAndGrowing(chosen, y, unseen),
        RisingSlope.of(x, y, objects, settings.seed()));
  }

  private static ShapeFit shape(List<ShapeFit> shapes, String name) {
    return shapes.stream().filter(fit -> fit.shape().equals(name)).findFirst().orElseThrow();
  }

  /**
   * Returns the scatter that models use, the one of least log loss; the constant one wins a tie.
   */
  public ScatterFit chosenScatter() {
    return scatters.stream()
        .min(Comparator.comparingDouble(fit -> fit.calibration().logLoss()))
        .orElseThrow();
  }

  /** Whether the fit is rejected, because confidence does not significantly rise with PIP. */
  public boolean rejected() {
    return !slope.significant();
  }

  /**
   * The scatter of residuals between objects and within one. The object is a random effect,
   * estimated by the moments of a one-way analysis of variance.
   *
   * @param between the standard deviation of the objects' offsets; 0 if there is only one object
   * @param within the standard deviation of an object's residuals about its offset
   */
  public record ObjectScatter(double between, double within) {
    /** Estimates the scatter of residuals. */
    static ObjectScatter of(double[] residuals, Groups objects) {
      int rows = residuals.length;
      int count = objects.count();
      double overallMean = mean(residuals);
      double withinSquares = 0;
      double betweenSquares = 0;
      double sumOfSquaredSizes = 0;
      for (int[] object : objects.rows()) {
        double[] objectResiduals = Groups.select(object, residuals);
        double mean = mean(objectResiduals);
        withinSquares += Arrays.stream(objectResiduals).map(r -> (r - mean) * (r - mean)).sum();
        betweenSquares += objectResiduals.length * (mean - overallMean) * (mean - overallMean);
        sumOfSquaredSizes += (double) objectResiduals.length * objectResiduals.length;
      }
      double within = withinSquares / Math.max(1, rows - count);
      double effectiveSize = (rows - sumOfSquaredSizes / rows) / Math.max(1, count - 1);
      double between = count > 1 ? (betweenSquares / (count - 1) - within) / effectiveSize : 0;
      return new ObjectScatter(Math.sqrt(Math.max(0, between)), Math.sqrt(within));
    }

    private static double mean(double[] values) {
      return Arrays.stream(values).average().orElse(0);
    }
  }
}
