package org.hificamsim.profiling.fit;

import java.util.Optional;

/**
 * A feature abstraction fitted to all rows, and how it does on rows that it has not seen.
 *
 * @param name short name, such as {@code lin}
 * @param scores on all rows, of {@code -log10(PIP)}
 * @param validation fits that each left a fold out
 * @param objects fits that each left an object out, where there is more than one
 * @param lenses fits that each left a focal length out, where there is more than one
 */
public record FeatureResult(
    String name,
    FittedFeature fit,
    Scores scores,
    CrossValidation validation,
    Optional<CrossValidation> objects,
    Optional<CrossValidation> lenses) {
  /** Fits that have not seen the objects that they are asked of; folds where there is but one. */
  public CrossValidation unseen() {
    return objects.orElse(validation);
  }
}
