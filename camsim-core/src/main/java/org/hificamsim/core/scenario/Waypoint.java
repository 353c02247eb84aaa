package org.hificamsim.core.scenario;

/** A corner of a target's path, metres. */
public record Waypoint(double x, double y) {}
