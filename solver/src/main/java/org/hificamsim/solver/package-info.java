/**
 * The parts that all solvers share: sets of targets as rows of bits, and branch and bound. The
 * problems are in the packages below.
 */
package org.hificamsim.solver;
