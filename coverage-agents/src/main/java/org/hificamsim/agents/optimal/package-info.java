/**
 * Bounds, which know what no camera can know: the exactly best configurations of each step and of a
 * run.
 */
package org.hificamsim.agents.optimal;
