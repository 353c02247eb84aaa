package org.hificamsim.profiling.lab;

import org.opencv.core.Point;
import org.opencv.core.Size;

/**
 * A pinhole camera (thesis 3.3) with a margin around its frame, since lens distortion may move
 * parts of the margin into view.
 *
 * @param focalLength z, in metres
 * @param width the width of the frame without the margin, in pixels
 * @param height the height of the frame without the margin, in pixels
 * @param margin the margin on each side, in pixels
 */
record Pinhole(
    double focalLength,
    double sensorWidth,
    double sensorHeight,
    int width,
    int height,
    int margin) {
  /** Returns the size of the canvas including the margin, in pixels. */
  Size canvas() {
    return new Size(width + 2.0 * margin, height + 2.0 * margin);
  }

  /** Returns the horizontal pixels per metre of the sensor. */
  double pitch() {
    return width / sensorWidth;
  }

  /** Returns the horizontal pixels per metre at this distance (metres). */
  double magnification(double distance) {
    return focalLength * pitch() / distance;
  }

  /** Projects a point (metres to the right, down and away) onto the canvas. */
  Point project(double x, double y, double away) {
    double vertical = focalLength * height / sensorHeight / away;
    return new Point(
        margin + width / 2.0 + x * magnification(away), margin + height / 2.0 + y * vertical);
  }
}
