package org.hificamsim.profiling.check;

import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;

/**
 * What is known of a real camera: which point of the world is where in its picture. The world is in
 * metres, its ground at z = 0 and its z upwards.
 */
interface Calibration {
  /** Where a point is in the picture; {@link Pixel#NONE} behind the camera. */
  Pixel project(Vector3D point);

  /** The direction from the camera to what is seen at a pixel. */
  Vector3D ray(Pixel pixel);

  /** The direction that it looks in: the optical axis. */
  Vector3D axis();

  /** Where the camera is. */
  Vector3D position();

  /** The focal length in pixels, upright. */
  double focalLength();

  /** The point of the ground that is seen at a pixel; NaN where that is above the horizon. */
  default Vector3D ground(Pixel pixel) {
    Vector3D ray = ray(pixel);
    double times = -position().getZ() / ray.getZ();
    return times > 0 ? position().add(ray.scalarMultiply(times)) : Vector3D.NaN;
  }

  /**
   * A place in a picture.
   *
   * @param u pixels to the right of the picture's left edge
   * @param v pixels down from its upper edge
   */
  record Pixel(double u, double v) {
    /** Nowhere in any picture. */
    static final Pixel NONE = new Pixel(Double.NaN, Double.NaN);

    /** How far another place is, pixels. */
    double distance(Pixel other) {
      return Math.hypot(u - other.u, v - other.v);
    }
  }
}
