package org.hificamsim.profiling.opencv;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import org.junit.jupiter.api.Test;
import org.opencv.core.Core;
import org.opencv.core.CvType;
import org.opencv.core.Mat;

class OpenCvTest {
  private static final OpenCv.Source LOADS = new OpenCv.Source("good", () -> {});
  private static final OpenCv.Source FAILS =
      new OpenCv.Source(
          "bad",
          () -> {
            throw new UnsatisfiedLinkError("wrong machine\nand more");
          });

  @Test
  void loadsOpenCvAndReportsItsSource() {
    OpenCv.load();
    assertTrue(OpenCv.version().matches("\\d.* \\(.+\\)"), OpenCv.version());
    assertEquals(1, Core.getNumThreads());
  }

  @Test
  void takesTheFirstSourceThatLoads() {
    assertEquals("good", OpenCv.loadFirst(List.of(FAILS, LOADS, FAILS)));
  }

  @Test
  void reportsAllFailedSourcesInOneLine() {
    List<OpenCv.Source> sources = List.of(FAILS, FAILS);
    String message =
        assertThrows(OpenCv.OpenCvMissingException.class, () -> OpenCv.loadFirst(sources))
            .getMessage();
    assertTrue(message.contains("(bad: wrong machine; bad: wrong machine)"), message);
    assertFalse(message.contains("\n"));
    assertTrue(message.contains("expected Debian's libopencv-java or org.openpnp:opencv"), message);
  }

  @Test
  void matsAreReleasedTogether() {
    OpenCv.load();
    Mat mat;
    try (Mats mats = new Mats()) {
      mat = mats.own(new Mat(10, 10, CvType.CV_8U));
      assertFalse(mat.empty());
    }
    assertTrue(mat.empty());
  }
}
