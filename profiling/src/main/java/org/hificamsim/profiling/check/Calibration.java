package org.hificamsim.profiling.check;

/**
 * What is known of a real camera: which point of the world is where in its picture. The world is in
 * metres, its ground at z = 0 and its z upwards.
 */
public interface Calibration {
  /** Where a point is in the picture; {@link Pixel#NONE} behind the camera. */
  Pixel project(Vector point);

  /** The direction from the camera to what is seen at a pixel. */
  Vector ray(Pixel pixel);

  /** Where the camera is. */
  Vector position();

  /** The focal length in pixels, upright. */
  double focalLength();

  /** The point of the ground that is seen at a pixel; NaN where that is above the horizon. */
  default Vector ground(Pixel pixel) {
    Vector ray = ray(pixel);
    double times = -position().z() / ray.z();
    return times > 0
        ? position().plus(ray.times(times))
        : new Vector(Double.NaN, Double.NaN, Double.NaN);
  }
}
