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
    Map<String, Double> thresholds) {}
