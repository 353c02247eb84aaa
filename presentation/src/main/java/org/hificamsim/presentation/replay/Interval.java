package org.hificamsim.presentation.replay;

/** A closed range of distances, metres. */
public record Interval(double from, double to) {}
