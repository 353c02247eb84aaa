package org.hificamsim.profiling.measure;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Random;
import org.hificamsim.profiling.opencv.Mats;
import org.hificamsim.profiling.opencv.OpenCv;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.Scalar;

class DistinctivenessTest {
  private static final int SIDE = 256;
  private static final int CELL = 16;

  @BeforeAll
  static void load() {
    OpenCv.load();
  }

  /** Noise has a corner in nearly every cell, a smooth grey none. */
  @Test
  void isTheShareOfTheCellsThatHaveTexture() {
    assertEquals(0, ofNoise(0));
    assertEquals(0.25, ofNoise(4), 0.05);
    assertEquals(0.75, ofNoise(12), 0.05);
  }

  private static double ofNoise(int columns) {
    Random random = new Random(1);
    try (Mats mats = new Mats()) {
      Mat picture = mats.own(new Mat(SIDE, SIDE, CvType.CV_8UC1, Scalar.all(128)));
      for (int y = 0; y < SIDE && columns > 0; y++) {
        byte[] row = new byte[columns * CELL];
        random.nextBytes(row);
        picture.put(y, 0, row);
      }
      return Distinctiveness.of(picture);
    }
  }
}
