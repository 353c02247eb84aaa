/**
 * The parts that all solvers share: sets of targets as rows of bits. The problems are in the
 * packages below.
 */
package org.hificamsim.solver;
