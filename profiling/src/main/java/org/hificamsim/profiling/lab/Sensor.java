package org.hificamsim.profiling.lab;

import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Core;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.Scalar;
import org.opencv.core.Size;
import org.opencv.imgproc.Imgproc;

/**
 * The image sensor of a Canon EOS 7D (thesis 3.5), with its vignetting, noise and 8-bit values.
 *
 * @param width pixels across the picture
 * @param height pixels down the picture
 */
record Sensor(int width, int height) {
  /** The width of the sensor, in metres. */
  static final double WIDTH = 0.0224;

  /** The height of the sensor, in metres. */
  static final double HEIGHT = 0.015;

  private static final int FULL_WIDTH_PIXELS = 5184;
  private static final int FULL_HEIGHT_PIXELS = 3456;
  private static final double FULL_WELL = 25_000;
  private static final double READ_NOISE = 8;
  private static final double GAMMA = 2.2;

  /** Returns the sensor with its width and height in pixels scaled by a share in (0, 1]. */
  static Sensor scaled(double share) {
    return new Sensor(
        (int) Math.round(FULL_WIDTH_PIXELS * share), (int) Math.round(FULL_HEIGHT_PIXELS * share));
  }

  /** Darkens the corners in place by the cos^4 law, with a strength in [0, 1]. */
  void vignette(Mat picture, double focalLength, double strength) {
    float[] row = new float[width];
    try (Mats mats = new Mats()) {
      Mat gains = mats.own(new Mat(height, width, CvType.CV_32F));
      for (int y = 0; y < height; y++) {
        double down = (y + 0.5 - height / 2.0) * HEIGHT / height;
        for (int x = 0; x < width; x++) {
          double right = (x + 0.5 - width / 2.0) * WIDTH / width;
          double tangentSquared = (right * right + down * down) / (focalLength * focalLength);
          double cosSquared = 1 / (1 + tangentSquared);
          row[x] = (float) (1 - strength * (1 - cosSquared * cosSquared));
        }
        gains.put(y, 0, row);
      }
      Mat colour = mats.mat();
      Imgproc.cvtColor(gains, colour, Imgproc.COLOR_GRAY2BGR);
      Core.multiply(picture, colour, picture);
    }
  }

  /**
   * Adds photon and read noise in place; fewer, larger pixels have less noise.
   *
   * @param iso the sensitivity; 0 adds no noise
   * @param seed the seed of the noise
   */
  void addNoise(Mat picture, double iso, int seed) {
    if (iso == 0) {
      return;
    }
    double binned = (double) FULL_WIDTH_PIXELS * FULL_HEIGHT_PIXELS / ((double) width * height);
    double electrons = FULL_WELL * 100 / iso;
    double read = READ_NOISE / electrons;
    try (Mats mats = new Mats()) {
      Mat deviation = mats.mat();
      Core.max(picture, Scalar.all(0), deviation);
      deviation.convertTo(deviation, -1, 1 / (electrons * binned), read * read / binned);
      Core.sqrt(deviation, deviation);
      Mat noise = mats.own(new Mat(picture.size(), picture.type()));
      Core.setRNGSeed(seed);
      Core.randn(noise, 0, 1);
      Core.multiply(noise, deviation, noise);
      Core.add(picture, noise, picture);
    }
  }

  /** Returns the picture in 8 bits with display gamma. */
  static Mat developed(Mat light) {
    try (Mats mats = new Mats()) {
      Mat clipped = mats.mat();
      Core.max(light, Scalar.all(0), clipped);
      Core.pow(clipped, 1 / GAMMA, clipped);
      Mat picture = new Mat();
      clipped.convertTo(picture, CvType.CV_8U, 255);
      return picture;
    }
  }

  /** Blurs the picture in place as diffraction does; {@code sigma} is in pixels. */
  static void diffract(Mat light, double sigma) {
    if (sigma > 0.1) {
      Imgproc.GaussianBlur(light, light, new Size(0, 0), sigma);
    }
  }
}
