package org.hificamsim.core.detection;

/**
 * One zoom setting of a camera, as a detection model sees it.
 *
 * @param radius radius of the field of view at this level, metres, 0 or more
 * @param narrowestRadius the camera's smallest radius, metres
 * @param widestRadius the camera's largest radius, metres
 * @param mountHeight height of the camera over the target plane, metres (Eq 3.2); NaN where the
 *     scenario gives none
 * @param viewingAngle full opening angle, radians, (0, 2 pi]
 */
public record ZoomLevel(
    double radius,
    double narrowestRadius,
    double widestRadius,
    double mountHeight,
    double viewingAngle) {
  /** Whether the camera sees all round. */
  public boolean allRound() {
    return viewingAngle >= 2 * Math.PI;
  }
}
