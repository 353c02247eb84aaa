/**
 * Bounds, which know what no camera can know: the exactly best configurations of each step and of a
 * run. They turn a network into a problem of detection sets, which {@code solver} solves and
 * proves.
 */
package org.hificamsim.agents.optimal;
