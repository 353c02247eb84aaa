package org.hificamsim.profiling.fit;

import java.util.List;

/** A way to fit a feature abstraction f: an extension point with two methods. */
public interface FeatureRegression {
  /** The short name in model names, such as {@code lin}. */
  String name();

  /**
   * Fits the observations; the same for the same observations.
   *
   * @throws org.hificamsim.core.InputException when they do not determine a fit
   */
  FittedFeature fit(List<Observation> observations);
}
