/**
 * The parts that all solvers share. A problem has sets of targets, of which it chooses some so that
 * targets are covered well; its sets are rows of a {@link org.hificamsim.solver.BitMatrix} where
 * they are combined. {@link org.hificamsim.solver.Exchange} makes a choice better, {@link
 * org.hificamsim.solver.PriceSearch} bounds all choices, and {@link
 * org.hificamsim.solver.BranchAndBound} closes the gap.
 *
 * <p>The problems are in the packages below: steps and runs, ways, and sites. Begin with {@link
 * org.hificamsim.solver.configuration.StepSolver}, which uses all four on one page.
 */
package org.hificamsim.solver;
