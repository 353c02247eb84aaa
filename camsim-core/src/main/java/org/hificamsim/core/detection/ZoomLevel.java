package org.hificamsim.core.detection;

/**
 * A zoom level of a camera, as detection models see it.
 *
 * @param radius farthest reach of the field of view at this level, in metres, 0 or more
 * @param narrowestRadius the camera's smallest radius, in metres
 * @param widestRadius the camera's largest radius, in metres
 * @param mountHeight height of the camera above the target plane, metres (Eq 3.2); NaN if the
 *     scenario gives none
 * @param viewingAngle full opening angle, in radians, (0, 2 pi]
 * @param angleOfView the horizontal angle of view of the lens, in radians, (0, pi]; NaN if the
 *     scenario names no lens, so that each model derives its own (Eqs 3.1 and 3.2)
 * @param pixels the width of the picture; 0 if the scenario does not give it
 * @param vertical the vertical part of the view
 */
public record ZoomLevel(
    double radius,
    double narrowestRadius,
    double widestRadius,
    double mountHeight,
    double viewingAngle,
    double angleOfView,
    int pixels,
    VerticalView vertical) {
  /** Creates a level in a flat world. */
  public ZoomLevel(
      double radius,
      double narrowestRadius,
      double widestRadius,
      double mountHeight,
      double viewingAngle,
      double angleOfView,
      int pixels) {
    this(
        radius,
        narrowestRadius,
        widestRadius,
        mountHeight,
        viewingAngle,
        angleOfView,
        pixels,
        VerticalView.FLAT);
  }

  /** Creates a level of a camera whose lens is unknown. */
  public ZoomLevel(
      double radius,
      double narrowestRadius,
      double widestRadius,
      double mountHeight,
      double viewingAngle) {
    this(radius, narrowestRadius, widestRadius, mountHeight, viewingAngle, Double.NaN, 0);
  }

  /** The same level with another vertical view. */
  public ZoomLevel with(VerticalView other) {
    return new ZoomLevel(
        radius,
        narrowestRadius,
        widestRadius,
        mountHeight,
        viewingAngle,
        angleOfView,
        pixels,
        other);
  }

  /** Whether the camera sees in all directions. */
  public boolean allRound() {
    return viewingAngle >= 2 * Math.PI;
  }

  /** Whether the scenario names the lens. */
  public boolean hasLens() {
    return !Double.isNaN(angleOfView);
  }
}
