package org.hificamsim.profiling.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.hificamsim.hifi.Residuals;
import org.junit.jupiter.api.Test;

/** Checks that a known scatter is estimated, with calibrated chances of a detection. */
class ScatterFitTest {
  private static final int OBJECTS = 40;
  private static final int PHOTOS = 50;

  private final Random random = new Random(3);
  private final double[] pip =
      IntStream.range(0, OBJECTS * PHOTOS)
          .mapToDouble(i -> Math.pow(10, -3 * random.nextDouble()))
          .toArray();
  private final Groups objects =
      new Groups(
          "object",
          IntStream.range(0, OBJECTS)
              .mapToObj(object -> IntStream.range(object * PHOTOS, (object + 1) * PHOTOS).toArray())
              .toList());

  /** Fits the scatter of confidences 0.05 + 0.4 p that have the scatter least + growth * 0.4 p. */
  private List<ScatterFit> fits(double least, double growth) {
    double[] y =
        Arrays.stream(pip)
            .map(p -> 0.05 + 0.4 * p + random.nextGaussian() * (least + growth * 0.4 * p))
            .toArray();
    ShapeFit g =
        ShapeFit.of(DetectorShape.of("line"), pip, Collections.nCopies(OBJECTS, pip), y, objects);
    return ScatterFit.constantAndGrowing(g, y, objects);
  }

  @Test
  void findsGrowingScatterWithCalibratedChances() {
    List<ScatterFit> fits = fits(0.01, 0.3);
    Residuals growing = fits.get(1).residuals();
    assertEquals(0.01, growing.least(), 0.001);
    assertEquals(0.3, growing.growth(), 0.03);
    assertTrue(growing.grow());
    Reliability after = fits.get(1).calibration();
    Reliability before = fits.get(0).calibration();
    assertEquals(0, after.all().error(), 0.02);
    assertEquals(0, after.worstFifth(), 0.05);
    assertTrue(before.worstFifth() > 0.05, "one number is off somewhere: " + before.fifths());
    assertTrue(after.logLoss() < before.logLoss());
  }

  @Test
  void bothKindsFindConstantScatter() {
    List<ScatterFit> fits = fits(0.05, 0);
    assertEquals(0.05, fits.get(0).residuals().least(), 0.002);
    assertFalse(fits.get(0).residuals().grow());
    assertEquals(0.05, fits.get(1).residuals().least(), 0.003);
    assertEquals(0, fits.get(1).residuals().growth(), 0.03);
    assertEquals(fits.get(0).residuals().rmse(), fits.get(1).residuals().rmse());
  }

  @Test
  void calibratesEachObjectByTheOthers() {
    double[] y = new double[pip.length];
    Arrays.setAll(y, i -> 0.05 + 0.4 * pip[i] + random.nextGaussian() * (i < PHOTOS ? 0.5 : 0.01));
    ShapeFit g =
        ShapeFit.of(DetectorShape.of("line"), pip, Collections.nCopies(OBJECTS, pip), y, objects);
    double[] detected =
        ScatterFit.constantAndGrowing(g, y, objects).get(0).calibration().detected();
    double scattered = Arrays.stream(detected, 0, PHOTOS).average().orElseThrow();
    double others = Arrays.stream(detected, PHOTOS, pip.length).average().orElseThrow();
    assertTrue(scattered > 0.6, "by the threshold of the others, which is low: " + scattered);
    assertTrue(others < 0.25, "by a threshold that the wild one has raised: " + others);
  }

  @Test
  void calibrationComparesChancesWithDetections() {
    double[] chances = {0.9, 0.1, 0.2, 0.8, 0.5, 0.5, 0.3, 0.7, 0.4, 0.6};
    double[] detected = {1, 0, 0, 1, 1, 0, 0, 1, 1, 1};
    Reliability all = new Reliability(chances, detected);
    assertEquals(0.5, all.all().expected(), 1e-12);
    assertEquals(0.6, all.all().detected(), 1e-12);
    assertEquals(-0.1, all.all().error(), 1e-12);
    assertEquals(5, all.fifths().size());
    assertEquals(0.15, all.fifths().get(0).expected(), 1e-12);
    assertEquals(0, all.fifths().get(0).detected());
    assertEquals(0.85, all.fifths().get(4).expected(), 1e-12);
    assertEquals(2, all.fifths().get(4).count());
    double loss = -Math.log(0.9) * 2 - Math.log(0.8) * 2 - Math.log(0.5) * 2 - Math.log(0.7) * 2;
    loss -= Math.log(0.4) + Math.log(0.6);
    assertEquals(loss / 10, all.logLoss(), 1e-12);
    assertEquals(
        -Math.log(1e-3),
        new Reliability(new double[] {0}, new double[] {1}).logLoss(),
        1e-12,
        "one photo does not make it infinite");
  }
}
