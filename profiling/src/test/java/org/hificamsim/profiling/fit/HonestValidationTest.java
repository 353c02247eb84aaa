package org.hificamsim.profiling.fit;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.Set;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.profiling.fit.DetectorFit.ObjectScatter;
import org.hificamsim.profiling.fit.FitSettings.SupportVectorSettings;
import org.hificamsim.profiling.fit.FitSettings.SymbolicSettings;
import org.hificamsim.profiling.measure.Measurement;
import org.junit.jupiter.api.Test;

/** Tests that validations use unseen objects, and that detectors of noise are rejected. */
class HonestValidationTest {
  private static final FitSettings QUICK =
      new FitSettings(
          5,
          0,
          new SymbolicSettings(50, 2, 0.001, 0, 1),
          SupportVectorSettings.THESIS,
          Optional.empty(),
          Map.of());

  /**
   * Records the rows of each fit, and checks that no row is predicted by a fit that has seen it.
   */
  @Test
  void predictsEveryRowByAFitWithoutTheRowsObject() {
    List<Measurement> rows = new Photos().detector("d", p -> p).take(1);
    Groups objects = Groups.byObject(rows);
    assertEquals(8, objects.count());
    List<Set<Double>> seen = new ArrayList<>();
    DetectorShape spy =
        new DetectorShape(
            "spy",
            (pip, y) -> {
              seen.add(Arrays.stream(y).boxed().collect(Collectors.toSet()));
              return new DetectorLine(0, seen.size());
            });
    double[] y = IntStream.range(0, rows.size()).asDoubleStream().toArray();
    ShapeFit fit = ShapeFit.of(spy, y, Collections.nCopies(8, y), y, objects);
    assertEquals(rows.size(), seen.get(0).size(), "the first fit has all rows");
    for (int group = 0; group < 8; group++) {
      for (int row : objects.rows().get(group)) {
        assertEquals(group + 2, fit.predicted()[row]);
        assertFalse(seen.get(group + 1).contains((double) row));
      }
      assertEquals(rows.size() - 40, seen.get(group + 1).size());
    }
  }

  @Test
  void groupsContainEveryRowOnce() {
    List<Measurement> rows = new Photos().detector("d", p -> p).take(1);
    for (Groups groups : List.of(Groups.byLens(rows), Groups.folds(rows.size(), 7, 3))) {
      List<Integer> sortedRows =
          groups.rows().stream().flatMapToInt(IntStream::of).sorted().boxed().toList();
      assertEquals(IntStream.range(0, rows.size()).boxed().toList(), sortedRows, groups.unit());
    }
    assertEquals(4, Groups.byLens(rows).count());
  }

  @Test
  void choosesSimplestShapeWithinOneStandardError() {
    // Errors of each object: the second is best; the first is worse by 1, 1, 1, 1 (surely), then by
    // 2, -1, 1, 0: mean 0.5, standard error of the mean sqrt(5/3/4) = 0.645.
    double[] best = {5, 9, 1, 3};
    assertEquals(1, OneStandardError.simplest(List.of(new double[] {6, 10, 2, 4}, best)));
    assertEquals(0, OneStandardError.simplest(List.of(new double[] {7, 8, 2, 3}, best)));
    assertEquals(0, OneStandardError.simplest(List.of(best, best.clone())));
    double[] unknown = {Double.NaN, 1, 1, 1};
    assertEquals(1, OneStandardError.simplest(List.of(unknown, best)));
  }

  @Test
  void choosesSaturatingCurveOrLineByTheData() {
    List<Measurement> rows =
        new Photos()
            .detector("saturates", p -> 0.05 + 0.7 * (1 - Math.exp(-p / 0.01)))
            .detector("straight", p -> 0.05 + 0.8 * p)
            .scatter(0.02, 0.03)
            .take(2);
    FitResult result = new Fitting(QUICK).fit(Photos.CAMERA, rows, 2);
    DetectorFit curve = result.model("saturates", FitResult.GROUND_TRUTH);
    assertTrue(
        Set.of("saturating-exponential", "hill").contains(curve.chosen().shape()),
        curve.chosen().shape());
    assertTrue(curve.shapes().get(0).unseen().r2() + 0.2 < curve.chosen().unseen().r2());
    assertEquals("line", result.model("straight", "pinhole").chosen().shape());
  }

  @Test
  void usesTheRequestedShape() {
    FitSettings asked =
        new FitSettings(
            5,
            0,
            QUICK.symbolic(),
            QUICK.vectors(),
            java.util.Optional.of("isotonic"),
            java.util.Map.of());
    List<Measurement> rows = new Photos().objects(4).detector("d", p -> 0.1 + 0.5 * p).take(2);
    FitResult result = new Fitting(asked).fit(Photos.CAMERA, rows, 2);
    assertEquals("isotonic", result.model("d", "power").chosen().shape());
  }

  /** The true values are 0.05 and 0.02, for 200 objects of 40 rows. */
  @Test
  void separatesScatterBetweenAndWithinObjects() {
    Random random = new Random(4);
    List<Measurement> rows =
        new Photos().objects(200).detector("d", p -> 0.5).scatter(0.05, 0.02).take(5);
    double[] residuals = rows.stream().mapToDouble(photo -> photo.confidence("d") - 0.5).toArray();
    ObjectScatter scatter = ObjectScatter.of(residuals, Groups.byObject(rows));
    assertEquals(0.05, scatter.between(), 0.006);
    assertEquals(0.02, scatter.within(), 0.001);
    double[] alike = residuals.clone();
    Arrays.setAll(alike, i -> random.nextGaussian());
    assertEquals(0, ObjectScatter.of(alike, Groups.byObject(rows)).between(), 0.1);
  }

  /**
   * Computed by hand: means 1 and 4, so MSB 4.5 * 2 = 9 (1 and 4 about 2.5, two rows each), MSW 1.
   */
  @Test
  void scatterEqualsAnalysisOfVariance() {
    Groups objects = new Groups("object", List.of(new int[] {0, 1}, new int[] {2, 3}));
    double half = Math.sqrt(0.5);
    double[] residuals = {1 - half, 1 + half, 4 - half, 4 + half};
    ObjectScatter scatter = ObjectScatter.of(residuals, objects);
    assertEquals(1, scatter.within(), 1e-12);
    assertEquals(2, scatter.between(), 1e-12); // sqrt((9 - 1) / 2)
  }

  @Test
  void differingObjectsWidenTheInterval() {
    Random random = new Random(6);
    List<Measurement> rows = new Photos().detector("d", p -> p).take(7);
    Groups objects = Groups.byObject(rows);
    double[] pip = rows.stream().mapToDouble(Measurement::pip).toArray();
    double[] y = new double[pip.length];
    for (int[] object : objects.rows()) {
      double own = 0.5 + 0.3 * random.nextGaussian();
      for (int row : object) {
        y[row] = own * pip[row] + 0.005 * random.nextGaussian();
      }
    }
    RisingSlope slope = RisingSlope.of(pip, y, objects, 0);
    Coefficient rowsAlone = LineFit.of(pip, y).slope();
    assertTrue(slope.high() - slope.low() > 3 * (rowsAlone.high() - rowsAlone.low()));
    assertTrue(slope.low() < slope.slope() && slope.slope() < slope.high());
    assertTrue(slope.significant());
  }

  @Test
  void rejectsNoise() {
    int refused = 0;
    for (int seed = 0; seed < 40; seed++) {
      List<Measurement> rows =
          new Photos().detector("noise", p -> 0.1).scatter(0.03, 0.05).take(seed);
      double[] pip = rows.stream().mapToDouble(Measurement::pip).toArray();
      double[] y = rows.stream().mapToDouble(photo -> photo.confidence("noise")).toArray();
      refused += RisingSlope.of(pip, y, Groups.byObject(rows), seed).significant() ? 0 : 1;
    }
    assertTrue(refused >= 36, "refused " + refused + " of 40");
  }

  @Test
  void rejectsConstantConfidences() {
    List<Measurement> rows =
        new Photos().objects(4).detector("constant", p -> 0.1 + 0.2).scatter(0, 0).take(1);
    FitResult result = new Fitting(QUICK).fit(Photos.CAMERA, rows, 2);
    assertTrue(result.model("constant", "power").rejected());
    assertTrue(Double.isNaN(result.line("constant", "power").r2()));
    assertTrue(Double.isNaN(result.model("constant", "power").chosen().unseen().r2()));
  }

  @Test
  void acceptsDetectorThatSaturatesEarly() {
    List<Measurement> rows =
        new Photos()
            .objects(5)
            .detector("yolo", p -> 0.9 * p / (p + 0.0004))
            .scatter(0.03, 0.03)
            .take(3);
    FitResult result = new Fitting(QUICK).fit(Photos.CAMERA, rows, 2);
    assertFalse(result.model("yolo", "pinhole").rejected());
    assertTrue(result.model("yolo", "pinhole").chosen().unseen().r2() > 0.8);
  }
}
