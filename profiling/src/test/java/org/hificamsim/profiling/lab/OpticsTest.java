package org.hificamsim.profiling.lab;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import org.hificamsim.profiling.opencv.Mats;
import org.hificamsim.profiling.opencv.OpenCv;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.opencv.core.Core;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.MatOfDouble;
import org.opencv.core.Point;
import org.opencv.core.Scalar;

/** Compares each part of the camera's physics with values computed by hand. */
class OpticsTest {
  private static final Pinhole CAMERA = new Pinhole(0.05, 0.0224, 0.015, 1296, 864, 10);

  @BeforeAll
  static void loadOpenCv() {
    OpenCv.load();
  }

  @Test
  void pinholeProjectsBySimilarTriangles() {
    Point centre = CAMERA.project(0, 0, 3);
    assertEquals(658, centre.x, 1e-9);
    assertEquals(442, centre.y, 1e-9);
    // 0.5 m at 4 m through 50 mm: 6.25 mm of 22.4 mm, of 1296 pixels.
    assertEquals(658 + 6.25 / 22.4 * 1296, CAMERA.project(0.5, 0, 4).x, 1e-9);
  }

  @Test
  void circleOfConfusionFollowsTheThinLens() {
    FocusedLens lens = new FocusedLens(0.085, 5.6, 2);
    assertEquals(0, lens.circleOfConfusion(2));
    // 85/5.6 mm * 10/12 * 0.085/1.915
    assertEquals(0.085 / 5.6 * 10 / 12 * 0.085 / 1.915, lens.circleOfConfusion(12), 1e-12);
    assertTrue(
        new FocusedLens(0.085, 11, 2).circleOfConfusion(12) < lens.circleOfConfusion(12) * 0.6);
    assertEquals(0, new FocusedLens(0.085, 0, 2).circleOfConfusion(12));
  }

  @Test
  void blurSpreadsAPointAndKeepsItsLight() {
    for (double diameter : new double[] {3, 9, 40}) {
      try (Mats mats = new Mats()) {
        Mat image = mats.own(Mat.zeros(161, 161, CvType.CV_32F));
        image.put(80, 80, new float[] {1});
        LensBlur.apply(image, diameter);
        assertEquals(1, Core.sumElems(image).val[0], 0.05);
        float[] outside = new float[1];
        image.get(80, (int) Math.min(160, 80 + diameter * 0.75 + 2), outside);
        assertEquals(0, outside[0], 1e-4);
        float[] within = new float[1];
        image.get(80, (int) (80 + diameter * 0.25), within);
        assertEquals(4 / (Math.PI * diameter * diameter), within[0], 0.35 / (diameter * diameter));
      }
    }
  }

  @Test
  void noiseGrowsWithIsoAndShrinksWithPixelSize() {
    double low = noise(Sensor.scaled(0.25), 100);
    double high = noise(Sensor.scaled(0.25), 6400);
    double large = noise(Sensor.scaled(0.125), 6400);
    // Photon noise grows by the root of 64 (read noise adds to it), and halves with the area times
    // 4.
    assertEquals(8, high / low, 1.5);
    assertEquals(2, high / large, 0.2);
    assertEquals(0, noise(Sensor.scaled(0.125), 0));
  }

  @Test
  void cornersDarkenByTheFourthPowerOfTheCosine() {
    Sensor sensor = new Sensor(224, 150);
    try (Mats mats = new Mats()) {
      Mat white = mats.own(new Mat(150, 224, CvType.CV_32FC3, Scalar.all(1)));
      sensor.vignette(white, 0.0112, 1);
      float[] pixel = new float[3];
      white.get(75, 223, pixel);
      // At the side's middle the tangent is 1 for a focal length of half the sensor: cos^4 = 1/4.
      assertEquals(0.25, pixel[0], 0.01);
      white.get(75, 112, pixel);
      assertEquals(1, pixel[0], 1e-3);
    }
  }

  @Test
  void wideLensesBarrelAndLongLensesPincushion() {
    assertTrue(RadialDistortion.typical(0.010, 1).k() > 0.04);
    assertEquals(0, RadialDistortion.typical(0.035, 1).k(), 1e-12);
    assertTrue(RadialDistortion.typical(0.085, 1).k() < 0);
    assertEquals(0, RadialDistortion.typical(0.010, 0).k(), 1e-12);
  }

  private static double noise(Sensor sensor, double iso) {
    try (Mats mats = new Mats()) {
      Mat grey =
          mats.own(new Mat(sensor.height(), sensor.width(), CvType.CV_32FC3, Scalar.all(0.5)));
      sensor.addNoise(grey, iso, 7);
      MatOfDouble mean = mats.own(new MatOfDouble());
      MatOfDouble deviation = mats.own(new MatOfDouble());
      Core.meanStdDev(grey, mean, deviation);
      assertEquals(0.5, mean.toArray()[0], 0.01);
      return deviation.toArray()[0];
    }
  }
}
