package org.hificamsim.profiling.fit;

import java.util.List;
import org.hificamsim.hifi.feature.FeatureAbstraction;
import org.hificamsim.hifi.feature.LogPipAbstraction;
import org.hificamsim.profiling.measure.Measurement;

/**
 * A feature abstraction that was fitted to data.
 *
 * @param equation in words that people read
 * @param coefficients as far as the method has any
 */
public record FittedFeature(FeatureAbstraction f, String equation, List<Coefficient> coefficients) {
  public FittedFeature {
    coefficients = List.copyOf(coefficients);
  }

  /** The predicted {@code -log10(PIP)}, unbounded where the abstraction predicts that itself. */
  public double response(Measurement o) {
    return f instanceof LogPipAbstraction log
        ? log.negativeLogPip(o.size(), o.distance(), o.focalLength())
        : -StrictMath.log10(pip(o));
  }

  /** The predicted PIP, [0, 1]. */
  public double pip(Measurement o) {
    return f.pip(o.size(), o.distance(), o.focalLength());
  }
}
