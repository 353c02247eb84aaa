package org.hificamsim.profiling.fit;

import java.util.List;
import org.hificamsim.hifi.feature.FeatureAbstraction;
import org.hificamsim.hifi.feature.LogPipAbstraction;
import org.hificamsim.profiling.measure.Measurement;

/**
 * A feature abstraction that was fitted to data.
 *
 * @param equation the equation as text for readers
 * @param coefficients the coefficients; empty if the method has none
 */
public record FittedFeature(FeatureAbstraction f, String equation, List<Coefficient> coefficients) {
  public FittedFeature {
    coefficients = List.copyOf(coefficients);
  }

  /**
   * Returns the predicted {@code -log10(PIP)}; unbounded if the abstraction predicts it directly.
   */
  public double response(Measurement photo) {
    return f instanceof LogPipAbstraction log
        ? log.negativeLogPip(photo.size(), photo.distance(), photo.focalLength())
        : -StrictMath.log10(pip(photo));
  }

  /** Returns the predicted PIP, [0, 1]. */
  public double pip(Measurement photo) {
    return f.pip(photo.size(), photo.distance(), photo.focalLength());
  }
}
