/**
 * Steps and runs: the configuration, one detection set for each camera, with the best score. Begin
 * with {@link org.hificamsim.solver.configuration.StepSolver}.
 */
package org.hificamsim.solver.configuration;
