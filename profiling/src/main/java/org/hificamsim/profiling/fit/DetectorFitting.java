package org.hificamsim.profiling.fit;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;

/** Fits every shape of g, and chooses one. */
final class DetectorFitting {
  private final Groups objects;
  private final Groups unseen;
  private final Optional<String> wanted;
  private final long seed;

  /**
   * @param objects the rows of each object
   * @param unseen what is left out together: objects, or folds where there is one object
   * @param wanted the shape that is taken whatever fits best
   */
  DetectorFitting(Groups objects, Groups unseen, Optional<String> wanted, long seed) {
    this.objects = objects;
    this.unseen = unseen;
    this.wanted = wanted;
    this.seed = seed;
  }

  /**
   * Fits one detector.
   *
   * @param x the PIP of each row
   * @param unseenX for each group the PIP of each row as an f says it that has not seen the group
   */
  DetectorFit fit(double[] x, double[][] unseenX, double[] y) {
    List<ShapeFit> shapes =
        DetectorShapes.all().stream()
            .map(shape -> ShapeFit.of(shape, x, unseenX, y, unseen))
            .toList();
    ShapeFit chosen = chosen(shapes);
    double[] residuals = new double[y.length];
    Arrays.setAll(residuals, i -> y[i] - chosen.g().confidence(x[i]));
    return new DetectorFit(
        shapes, chosen, ObjectScatter.of(residuals, objects), RisingSlope.of(x, y, objects, seed));
  }

  private ShapeFit chosen(List<ShapeFit> shapes) {
    return wanted
        .map(name -> shapes.stream().filter(one -> one.shape().equals(name)).findFirst())
        .orElseGet(
            () ->
                Optional.of(
                    shapes.get(
                        OneStandardError.simplest(
                            shapes.stream().map(ShapeFit::groupErrors).toList()))))
        .orElseThrow();
  }
}
