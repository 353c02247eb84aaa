package org.hificamsim.profiling.dataset;

import java.nio.file.Path;
import org.hificamsim.hifi.json.JsonFile;

/**
 * The camera that took the pictures of a data set ({@code camera.json}).
 *
 * @param sensorWidth the sensor width in metres
 * @param sensorHeight the sensor height in metres
 * @param width the width of pictures in landscape orientation, in pixels
 * @param height the height of pictures in landscape orientation, in pixels
 */
public record PhotoCamera(double sensorWidth, double sensorHeight, int width, int height) {
  private static final int MAX_PIXELS = 100_000;
  private static final int MAX_BYTES = 1 << 20;

  /**
   * Reads the camera of a data set's folder.
   *
   * @throws org.hificamsim.core.InputException with line and column, when {@code camera.json} is
   *     missing or wrong
   */
  public static PhotoCamera of(Path folder) {
    return JsonFile.read(
            folder.resolve(Dataset.CAMERA), "the camera's sensor and pixels", MAX_BYTES)
        .readWhole(
            json ->
                new PhotoCamera(
                    json.number("sensorWidth", 1e-6, 1),
                    json.number("sensorHeight", 1e-6, 1),
                    (int) json.number("width", 1, MAX_PIXELS),
                    (int) json.number("height", 1, MAX_PIXELS)));
  }

  /** Returns the number of pixels of every picture. */
  public long pixels() {
    return (long) width * height;
  }

  /** Returns the share of the picture that an object fills in a pinhole camera (thesis 3.3). */
  public double pinholePip(double size, double distance, double focalLength) {
    double imageLength = size * focalLength / distance;
    return imageLength * imageLength / (sensorWidth * sensorHeight);
  }

  /** Whether the camera takes pictures of this size, in landscape or portrait orientation. */
  boolean takes(int pictureWidth, int pictureHeight) {
    return (pictureWidth == width && pictureHeight == height)
        || (pictureWidth == height && pictureHeight == width);
  }
}
