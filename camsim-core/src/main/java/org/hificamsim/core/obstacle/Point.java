package org.hificamsim.core.obstacle;

/** A point in the plane, in metres. */
public record Point(double x, double y) {}
