package org.hificamsim.profiling.fit;

/**
 * How models are fitted.
 *
 * @param folds of the cross-validation
 * @param seed of the shuffle and of the genetic programming
 * @param symbolic how symbolic regression runs
 * @param vectors how support vectors are trained
 */
public record FitSettings(
    int folds, long seed, SymbolicSettings symbolic, SupportVectorSettings vectors) {
  /** The thesis's: five folds (thesis 4.4). */
  public static FitSettings thesis(long seed) {
    return new FitSettings(5, seed, SymbolicSettings.thesis(seed), SupportVectorSettings.THESIS);
  }
}
