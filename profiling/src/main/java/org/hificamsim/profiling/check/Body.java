package org.hificamsim.profiling.check;

/**
 * What targets are assumed to be like.
 *
 * @param height metres
 * @param width metres
 */
public record Body(double height, double width) {}
