package org.hificamsim.core.obstacle;

/** A corner, metres. */
public record Point(double x, double y) {}
