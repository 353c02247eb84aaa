package org.hificamsim.profiling.fit;

/**
 * A feature abstraction fitted to all rows, and its cross-validation.
 *
 * @param name short name, such as {@code lin}
 * @param scores on all rows, of {@code -log10(PIP)}
 * @param validation five fits that each left a fold out
 */
public record FeatureResult(
    String name, FittedFeature fit, Scores scores, CrossValidation validation) {}
