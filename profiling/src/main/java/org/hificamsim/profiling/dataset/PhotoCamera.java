package org.hificamsim.profiling.dataset;

/**
 * The camera that took the pictures of a data set ({@code camera.json}).
 *
 * @param sensorWidth metres
 * @param sensorHeight metres
 * @param width of every picture as the camera is held level, pixels
 * @param height of the same, pixels
 */
public record PhotoCamera(double sensorWidth, double sensorHeight, int width, int height) {
  /** The number of pixels of every picture. */
  public long pixels() {
    return (long) width * height;
  }

  /** The share of the picture that a pinhole camera gives an object (thesis 3.3). */
  public double pinholePip(double size, double distance, double focalLength) {
    double seen = size * focalLength / distance;
    return seen * seen / (sensorWidth * sensorHeight);
  }

  /** Whether a picture of this size is this camera's, held level or upright. */
  boolean takes(int pictureWidth, int pictureHeight) {
    return (pictureWidth == width && pictureHeight == height)
        || (pictureWidth == height && pictureHeight == width);
  }
}
