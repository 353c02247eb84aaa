package org.hificamsim.presentation.replay;

import java.util.List;

/**
 * Where a camera stands, where it looks and how far.
 *
 * @param x metres
 * @param y metres
 * @param heading radians, 0 is +y and pi/2 is +x; not normalised
 * @param viewingAngle full opening angle, radians, (0, 2 pi]
 * @param levels its zoom levels, the narrowest first
 */
public record CameraPose(
    double x, double y, double heading, double viewingAngle, List<Level> levels) {}
