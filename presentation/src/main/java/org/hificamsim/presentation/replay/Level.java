package org.hificamsim.presentation.replay;

import java.util.List;

/**
 * A zoom level of a camera.
 *
 * @param radius of the field of view, metres
 * @param detected the distances at which a target of the usual size is detected, ascending
 */
public record Level(double radius, List<Interval> detected) {}
