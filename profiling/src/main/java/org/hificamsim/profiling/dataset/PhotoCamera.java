package org.hificamsim.profiling.dataset;

import java.nio.file.Path;
import org.hificamsim.hifi.json.JsonFile;

/**
 * The camera that took the pictures of a data set ({@code camera.json}).
 *
 * @param sensorWidth metres
 * @param sensorHeight metres
 * @param width of every picture as the camera is held level, pixels
 * @param height of the same, pixels
 */
public record PhotoCamera(double sensorWidth, double sensorHeight, int width, int height) {
  private static final int MAX_PIXELS = 100_000;
  private static final int MAX_BYTES = 1 << 20;

  /**
   * The camera that took a data set's pictures.
   *
   * @throws org.hificamsim.core.InputException with its place, when {@code camera.json} is missing
   *     or wrong
   */
  public static PhotoCamera of(Path folder) {
    return JsonFile.read(
            folder.resolve(Dataset.CAMERA), "the camera's sensor and pixels", MAX_BYTES)
        .whole(
            json ->
                new PhotoCamera(
                    json.number("sensorWidth", 1e-6, 1),
                    json.number("sensorHeight", 1e-6, 1),
                    (int) json.number("width", 1, MAX_PIXELS),
                    (int) json.number("height", 1, MAX_PIXELS)));
  }

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
