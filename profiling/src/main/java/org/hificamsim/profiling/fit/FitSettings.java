package org.hificamsim.profiling.fit;

import java.util.Map;
import java.util.Optional;

/**
 * How models are fitted.
 *
 * @param folds of the cross-validation
 * @param seed of the shuffle, of the bootstrap and of the genetic programming
 * @param symbolic how symbolic regression runs
 * @param vectors how support vectors are trained
 * @param shape the name of the shape of g that is taken; without one it is chosen
 * @param thresholds by detector, from which measured confidence on it detects, where that is known
 */
public record FitSettings(
    int folds,
    long seed,
    SymbolicSettings symbolic,
    SupportVectorSettings vectors,
    Optional<String> shape,
    Map<String, Double> thresholds) {
  /**
   * What genetic programming runs with.
   *
   * @param population programs in each generation
   * @param generations how many
   * @param parsimony what each node of a program costs, in units of the mean squared error
   * @param seed of everything random
   * @param restarts how many runs, of which the best is taken; 1 is the thesis's
   */
  public record SymbolicSettings(
      int population, int generations, double parsimony, long seed, int restarts) {}

  /**
   * What an epsilon support vector regression is trained with (Eq 4.8).
   *
   * @param epsilon half the width of the tube whose errors cost nothing
   * @param penalty C, what an error beyond it costs
   * @param tolerance when the optimisation stops
   */
  public record SupportVectorSettings(double epsilon, double penalty, double tolerance) {
    /** The thesis's epsilon and C (thesis 4.5.3), and LIBSVM's tolerance. */
    public static final SupportVectorSettings THESIS = new SupportVectorSettings(0.1, 1, 1e-3);
  }
}
