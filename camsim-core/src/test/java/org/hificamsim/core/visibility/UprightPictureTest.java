package org.hificamsim.core.visibility;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Random;
import org.hificamsim.core.detection.VerticalView;
import org.junit.jupiter.api.Test;

/** Compares sizes in the picture with a full projection of many points of an upright rectangle. */
class UprightPictureTest {
  private static final double WIDTH = 0.5;
  private static final double HEIGHT = 1.75;
  private static final int CAMERAS = 2_000;

  @Test
  void predictsBoxesOfTiltedCamerasUnlikeFlatWorld() {
    Random random = new Random(3);
    double[] flat = new double[CAMERAS];
    for (int i = 0; i < CAMERAS; i++) {
      double z = 2.5 + 5.5 * random.nextDouble();
      double tilt = Math.toRadians(60 * random.nextDouble());
      VerticalView view = new VerticalView(z, tilt, Double.NaN);
      double ahead = 0;
      double right = 0;
      double[] full = {Double.NaN};
      // Draw until the whole rectangle is in a picture of 90 degrees.
      while (!(full[0] > 0)) {
        ahead = 1 + 30 * random.nextDouble();
        right = 10 * random.nextDouble() - 5;
        full = projected(z, tilt, ahead, right);
      }
      UprightPicture picture = UprightPicture.of(view, ahead, right, WIDTH, HEIGHT);
      assertEquals(full[0], picture.width(), 0.005 * full[0]);
      assertEquals(full[1], picture.height(), 0.005 * full[1]);
      flat[i] = Math.abs(HEIGHT / Math.hypot(ahead, right) / full[1] - 1);
    }
    Arrays.sort(flat);
    assertTrue(flat[CAMERAS / 2] > 0.1, () -> "flat errs by " + flat[CAMERAS / 2]);
  }

  /** Returns the width and height of an upright rectangle in the picture; NaN if it is cut off. */
  private static double[] projected(double z, double tilt, double ahead, double right) {
    double[][] turn = {
      {1, 0, 0},
      {0, Math.cos(tilt), -Math.sin(tilt)},
      {0, Math.sin(tilt), Math.cos(tilt)}
    };
    double[] least = {Double.MAX_VALUE, Double.MAX_VALUE};
    double[] most = {-Double.MAX_VALUE, -Double.MAX_VALUE};
    double bearing = Math.atan2(right, ahead);
    for (int i = 0; i <= 10; i++) {
      for (int j = 0; j <= 10; j++) {
        double aside = (i / 10.0 - 0.5) * WIDTH;
        double[] point = {
          right + aside * Math.cos(bearing),
          ahead - aside * Math.sin(bearing),
          j / 10.0 * HEIGHT - z
        };
        double[] seen = new double[3];
        for (int row = 0; row < 3; row++) {
          for (int column = 0; column < 3; column++) {
            seen[row] += turn[row][column] * point[column];
          }
        }
        double across = seen[0] / seen[1];
        double up = seen[2] / seen[1];
        if (seen[1] <= 0 || Math.abs(across) > 1 || Math.abs(up) > 1) {
          return new double[] {Double.NaN};
        }
        least = new double[] {Math.min(least[0], across), Math.min(least[1], up)};
        most = new double[] {Math.max(most[0], across), Math.max(most[1], up)};
      }
    }
    return new double[] {most[0] - least[0], most[1] - least[1]};
  }
}
