package org.hificamsim.core.detection;

/**
 * One zoom setting of a camera, as a detection model sees it.
 *
 * @param radius farthest reach of the field of view at this level, metres, 0 or more
 * @param narrowestRadius the camera's smallest radius, metres
 * @param widestRadius the camera's largest radius, metres
 * @param mountHeight height of the camera over the target plane, metres (Eq 3.2); NaN where the
 *     scenario gives none
 * @param viewingAngle full opening angle, radians, (0, 2 pi]
 * @param angleOfView what the lens has in its picture from side to side, radians, (0, pi]; NaN
 *     where the scenario names no lens, and each model has to find its own (Eqs 3.1 and 3.2)
 * @param pixels the picture's width; 0 where the scenario does not say
 * @param vertical how the camera looks up and down
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
  /** A level in a flat world. */
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

  /** A level of a camera whose lens is not known. */
  public ZoomLevel(
      double radius,
      double narrowestRadius,
      double widestRadius,
      double mountHeight,
      double viewingAngle) {
    this(radius, narrowestRadius, widestRadius, mountHeight, viewingAngle, Double.NaN, 0);
  }

  /** The same level of a camera that looks up and down another way. */
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

  /** Whether the camera sees all round. */
  public boolean allRound() {
    return viewingAngle >= 2 * Math.PI;
  }

  /** Whether the scenario says through which lens the camera looks. */
  public boolean hasLens() {
    return !Double.isNaN(angleOfView);
  }
}
