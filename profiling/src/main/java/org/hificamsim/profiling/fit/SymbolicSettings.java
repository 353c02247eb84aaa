package org.hificamsim.profiling.fit;

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
