package org.hificamsim.profiling.fit;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.hifi.detector.DetectorModel;

/**
 * A detector model g of one shape, with its cross-validation.
 *
 * @param shape the name of the shape
 * @param g the fit to all rows
 * @param scores the scores of g on all rows
 * @param fits for each group, the fit without it
 * @param predicted the prediction of each row by the fit without its group
 * @param unseen the scores of these predictions
 * @param groupErrors the mean squared error of these predictions in each group
 */
public record ShapeFit(
    String shape,
    DetectorModel g,
    FitScores scores,
    List<DetectorModel> fits,
    double[] predicted,
    FitScores unseen,
    double[] groupErrors) {
  /**
   * Fits a shape to all rows, and once without each group.
   *
   * @param x the PIP of each row
   * @param unseenX for each group the PIP of each row, predicted by an f fitted without the group
   */
  public static ShapeFit of(
      DetectorShape shape, double[] x, List<double[]> unseenX, double[] y, Groups groups) {
    DetectorModel g = shape.fit(x, y);
    List<DetectorModel> fits =
        IntStream.range(0, groups.count())
            .mapToObj(
                group -> {
                  int[] others = groups.others(group);
                  return shape.fit(
                      Groups.select(others, unseenX.get(group)), Groups.select(others, y));
                })
            .toList();
    double[] predicted =
        groups.forEachRow((group, row) -> fits.get(group).confidence(unseenX.get(group)[row]));
    double[] fitted = Arrays.stream(x).map(g::confidence).toArray();
    return new ShapeFit(
        shape.name(),
        g,
        FitScores.of(y, fitted),
        fits,
        predicted,
        FitScores.of(y, predicted),
        groups.scores(y, predicted).stream().mapToDouble(FitScores::mse).toArray());
  }
}
