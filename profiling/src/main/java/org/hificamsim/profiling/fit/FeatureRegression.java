package org.hificamsim.profiling.fit;

import java.util.List;
import java.util.function.Function;
import org.hificamsim.profiling.measure.Measurement;

/**
 * A way to fit a feature abstraction f: an extension point; a line in {@link FeatureRegressions}.
 *
 * @param name the short name in model names, such as {@code lin}
 * @param method fits photos; the same for the same photos
 */
public record FeatureRegression(String name, Function<List<Measurement>, FittedFeature> method) {
  /**
   * Fits photos.
   *
   * @throws org.hificamsim.core.InputException when they do not determine a fit
   */
  public FittedFeature fit(List<Measurement> photos) {
    return method.apply(photos);
  }
}
