package org.hificamsim.profiling.lab;

import org.opencv.core.Point;
import org.opencv.core.Size;

/**
 * A pinhole camera (thesis 3.3) with a margin around its frame, which lens distortion moves into
 * view.
 *
 * @param focalLength z, metres
 * @param width of the frame, pixels, without the margin
 * @param height of the frame, pixels, without the margin
 * @param margin on each side, pixels
 */
record Pinhole(
    double focalLength,
    double sensorWidth,
    double sensorHeight,
    int width,
    int height,
    int margin) {
  /** The size of the canvas, margin included, pixels. */
  Size canvas() {
    return new Size(width + 2.0 * margin, height + 2.0 * margin);
  }

  /** Pixels per metre of the sensor, across. */
  double pitch() {
    return width / sensorWidth;
  }

  /** How many pixels a metre at this distance (metres) measures, across. */
  double magnification(double distance) {
    return focalLength * pitch() / distance;
  }

  /** Where a point (metres; right, down, away) falls on the canvas. */
  Point project(double x, double y, double away) {
    double vertical = focalLength * height / sensorHeight / away;
    return new Point(
        margin + width / 2.0 + x * magnification(away), margin + height / 2.0 + y * vertical);
  }
}
