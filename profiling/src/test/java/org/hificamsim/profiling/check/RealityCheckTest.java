package org.hificamsim.profiling.check;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import org.apache.commons.math3.geometry.euclidean.threed.Vector3D;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.profiling.check.Calibration.Pixel;
import org.hificamsim.profiling.check.Calibration.Size;
import org.hificamsim.profiling.check.MotSightings.Sighting;
import org.hificamsim.tracks.format.MotFile;
import org.junit.jupiter.api.Test;

/** Checks boxes of a synthetic camera with known errors. */
class RealityCheckTest {
  private static final Size BODY = new Size(0.5, 1.75);
  private static final Calibration TILTED = MadeCameras.at(6, 15, MadeCameras.bent(0.004));

  @Test
  void calibratedBoxesHaveNoError() {
    RealityCheck check = check(TILTED, i -> 0);
    for (ErrorSummary summary : check.overall()) {
      if (summary.rung().equals("calibration")) {
        assertEquals(0, summary.median(), 1e-12);
        assertEquals(0, summary.bias(), 1e-12);
        assertEquals(200, summary.boxes());
      }
    }
    assertEquals(0, check.footError(), 1e-9);
  }

  @Test
  void heightsEqualCalibrationButFlatWorldDoesNot() {
    RealityCheck check = check(MadeCameras.at(6, 15, MadeCameras.LENS), i -> 0);
    assertEquals(0, of(check, "heights", "height").ninety(), 0.005);
    assertTrue(of(check, "flat", "height").median() > 0.03);
  }

  @Test
  void findsKnownBias() {
    ErrorSummary height = of(check(TILTED, i -> 0.05), "calibration", "height");
    assertEquals(0.05, height.median(), 1e-9);
    assertEquals(0.05, height.ninety(), 1e-9);
    assertEquals(0.05, height.bias(), 1e-9);
    ErrorSummary pip = of(check(TILTED, i -> 0.05), "calibration", "pip");
    assertEquals(1.05 * 1.05 - 1, pip.bias(), 1e-9, "an area");
  }

  @Test
  void findsQuantilesOfKnownNoise() {
    ErrorSummary height =
        of(check(TILTED, i -> -0.2 + 0.4 * (i + 0.5) / 200), "calibration", "height");
    assertEquals(0.1, height.median(), 0.002, "evenly from -20 to 20 %");
    assertEquals(0.18, height.ninety(), 0.002);
    assertEquals(0, height.bias(), 1e-9);
  }

  @Test
  void flatWorldIsExactOnlyOnTheAxis() {
    Calibration level = MadeCameras.at(1.5, 0, MadeCameras.LENS);
    List<Sighting> sightings =
        List.of(sighting(level, 0, 20, 0), sighting(level, 15, 20, 0), sighting(level, 0, 10, 0));
    RealityCheck check = RealityCheck.of(sightings, level, BODY);
    assertEquals(0, check.comparisons().get(0).error(SizeModel.FLAT, BoxQuantity.HEIGHT), 1e-12);
    assertEquals(
        20 / 25.0 - 1, check.comparisons().get(1).error(SizeModel.FLAT, BoxQuantity.HEIGHT), 1e-12);
    assertEquals(0, check.comparisons().get(2).error(SizeModel.FLAT, BoxQuantity.HEIGHT), 1e-12);
    assertEquals(
        0, check.comparisons().get(1).error(SizeModel.CALIBRATION, BoxQuantity.HEIGHT), 1e-12);
  }

  @Test
  void reportsErrorsThatGrowWithDistance() {
    List<Sighting> sightings = new ArrayList<>();
    for (int i = 0; i < 100; i++) {
      double y = 10 + 0.3 * i;
      sightings.add(sighting(TILTED, 0, y, y / 400));
    }
    List<ErrorSummary> bands =
        RealityCheck.of(sightings, TILTED, BODY).byDistance().stream()
            .filter(
                summary ->
                    summary.rung().equals("calibration") && summary.quantity().equals("height"))
            .toList();
    assertEquals(100, bands.stream().mapToInt(ErrorSummary::boxes).sum(), "each in one band");
    assertTrue(bands.size() > 3 && bands.size() <= 9, bands.size() + " bands");
    for (ErrorSummary band : bands) {
      double middle = (Math.max(10, band.from()) + Math.min(40, band.to())) / 2;
      assertEquals(middle / 400, band.bias(), 0.002, "from " + band.from());
    }
  }

  @Test
  void rejectsPositionsInAnotherUnit() {
    List<Sighting> off =
        sightings(TILTED, i -> 0).stream()
            .map(sighting -> moved(sighting, new Vector3D(0, 15, 0)))
            .toList();
    InputException other =
        assertThrows(InputException.class, () -> RealityCheck.of(off, TILTED, BODY));
    assertTrue(other.getMessage().contains("maybe unit or calibration_unit"), other.getMessage());
    List<Sighting> behind =
        off.stream().map(sighting -> moved(sighting, new Vector3D(0, -500, 0))).toList();
    assertTrue(
        assertThrows(InputException.class, () -> RealityCheck.of(behind, TILTED, BODY))
            .getMessage()
            .startsWith("none of 200 boxes"));
  }

  private static ErrorSummary of(RealityCheck check, String rung, String quantity) {
    return check.overall().stream()
        .filter(summary -> summary.rung().equals(rung) && summary.quantity().equals(quantity))
        .findFirst()
        .orElseThrow();
  }

  private static RealityCheck check(Calibration camera, IntToDoubleFunction error) {
    return RealityCheck.of(sightings(camera, error), camera, BODY);
  }

  /** Returns two hundred sightings, evenly over a strip of ground. */
  private static List<Sighting> sightings(Calibration camera, IntToDoubleFunction error) {
    return IntStream.range(0, 200)
        .mapToObj(
            i -> sighting(camera, -4 + i % 9, 12 + i * 37 % 200 * 0.12, error.applyAsDouble(i)))
        .toList();
  }

  /**
   * Returns a sighting whose box is smaller than predicted, so that the prediction has this error.
   */
  private static Sighting sighting(Calibration camera, double x, double y, double error) {
    Vector3D foot = new Vector3D(x, y, 0);
    Size predicted = SizeModel.CALIBRATION.size(camera, foot, BODY);
    Pixel stand = camera.project(foot);
    double width = predicted.width() / (1 + error);
    double height = predicted.height() / (1 + error);
    double left = stand.u() - width / 2;
    MotFile.Row box =
        new MotFile.Row(
            new Place("made", 1, 1),
            1,
            "1",
            left,
            stand.v() - height,
            width,
            height,
            1,
            x,
            y,
            0,
            "",
            Double.NaN);
    return new Sighting(box, foot);
  }

  private static Sighting moved(Sighting sighting, Vector3D by) {
    return new Sighting(sighting.box(), sighting.foot().add(by));
  }
}
