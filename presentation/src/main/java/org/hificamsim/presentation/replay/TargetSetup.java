package org.hificamsim.presentation.replay;

/**
 * A target.
 *
 * @param size edge of its bounding box, metres
 */
public record TargetSetup(String name, double size) {}
