package org.hificamsim.core.visibility;

import org.hificamsim.core.detection.VerticalView;

/**
 * The bounding box of the picture of an upright rectangle that faces the camera, projected by a
 * pinhole at a height and a tilt through all four corners.
 *
 * @param width the width in focal lengths; times the focal length in pixels it is in pixels
 * @param height the height in focal lengths
 */
public record UprightPicture(double width, double height) {
  /**
   * Projects a rectangle that stands on the ground in front of the camera.
   *
   * @param ahead metres ahead of the camera, along its heading
   * @param right metres to its right
   * @param bodyWidth the body width, in metres
   * @param bodyHeight the body height, in metres
   */
  public static UprightPicture of(
      VerticalView view, double ahead, double right, double bodyWidth, double bodyHeight) {
    double distance = Math.hypot(ahead, right);
    double sine = StrictMath.sin(view.tilt());
    double cosine = StrictMath.cos(view.tilt());
    double left = Double.POSITIVE_INFINITY;
    double rightmost = Double.NEGATIVE_INFINITY;
    double bottom = Double.POSITIVE_INFINITY;
    double top = Double.NEGATIVE_INFINITY;
    for (int corner = 0; corner < 4; corner++) {
      double aside = (corner % 2 - 0.5) * bodyWidth / distance;
      double x = right + aside * ahead;
      double y = ahead - aside * right;
      double below = view.z() - (corner < 2 ? 0 : bodyHeight);
      double depth = y * cosine + below * sine;
      left = Math.min(left, x / depth);
      rightmost = Math.max(rightmost, x / depth);
      bottom = Math.min(bottom, (y * sine - below * cosine) / depth);
      top = Math.max(top, (y * sine - below * cosine) / depth);
    }
    return new UprightPicture(rightmost - left, top - bottom);
  }
}
