package org.hificamsim.profiling.fit;

import java.util.Arrays;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.hifi.detector.DetectorModel;

/**
 * A detector model g of one shape, and how it does on groups of rows that it has not seen.
 *
 * @param shape its name
 * @param g fitted to all rows
 * @param scores on all rows
 * @param fits without each group
 * @param predicted what a fit without its group says of each row
 * @param unseen the scores of that
 * @param groupErrors the mean squared error of that in each group
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
   * @param unseenX for each group the PIP of each row as an f says it that has not seen the group
   */
  public static ShapeFit of(
      DetectorShape shape, double[] x, List<double[]> unseenX, double[] y, Groups groups) {
    DetectorModel g = shape.fit(x, y);
    List<DetectorModel> fits =
        IntStream.range(0, groups.count())
            .mapToObj(
                group -> {
                  int[] others = groups.others(group);
                  return shape.fit(Groups.at(others, unseenX.get(group)), Groups.at(others, y));
                })
            .toList();
    double[] predicted =
        groups.each((group, row) -> fits.get(group).confidence(unseenX.get(group)[row]));
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
