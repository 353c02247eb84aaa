package org.hificamsim.core.obstacle;

/** A point in the plane, metres. */
public record Point(double x, double y) {}
