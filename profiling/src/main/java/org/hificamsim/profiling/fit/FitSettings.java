package org.hificamsim.profiling.fit;

import java.util.Map;
import java.util.Optional;

/**
 * The settings of a fit.
 *
 * @param folds the number of folds of the cross-validation
 * @param seed the seed of the folds, the bootstrap and the genetic programming
 * @param symbolic the settings of symbolic regression
 * @param vectors the settings of support vector regression
 * @param shape the name of the shape of g; if empty, the best is chosen
 * @param thresholds the known thresholds by detector, the least confidence of a detection
 */
public record FitSettings(
    int folds,
    long seed,
    SymbolicSettings symbolic,
    SupportVectorSettings vectors,
    Optional<String> shape,
    Map<String, Double> thresholds) {
  /**
   * The settings of genetic programming.
   *
   * @param population the number of programs in each generation
   * @param generations the number of generations
   * @param parsimony the cost of each node of a program, in units of the mean squared error
   * @param seed the seed of all random numbers
   * @param restarts the number of runs, of which the best is used; 1 in the thesis
   */
  public record SymbolicSettings(
      int population, int generations, double parsimony, long seed, int restarts) {}

  /**
   * The settings of epsilon support vector regression (Eq 4.8).
   *
   * @param epsilon the largest error without a cost
   * @param penalty C, the cost per unit of a larger error
   * @param tolerance the tolerance at which the optimisation stops
   */
  public record SupportVectorSettings(double epsilon, double penalty, double tolerance) {
    /** The epsilon and C of thesis 4.5.3, and the tolerance of LIBSVM. */
    public static final SupportVectorSettings THESIS = new SupportVectorSettings(0.1, 1, 1e-3);
  }
}
