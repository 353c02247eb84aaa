package org.hificamsim.profiling.report;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.io.InputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.Random;
import java.util.stream.Stream;
import org.apache.commons.math3.stat.regression.SimpleRegression;
import org.hificamsim.core.Reference;
import org.hificamsim.core.detection.ZoomLevel;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.data.CsvReader;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.model.ModelFiles;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.profiling.dataset.PhotoCamera;
import org.hificamsim.profiling.fit.FeatureResult;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.FitSettings;
import org.hificamsim.profiling.fit.FitSettings.SupportVectorSettings;
import org.hificamsim.profiling.fit.FitSettings.SymbolicSettings;
import org.hificamsim.profiling.fit.Fitting;
import org.hificamsim.profiling.fit.Photos;
import org.hificamsim.profiling.fit.Recommendation;
import org.hificamsim.profiling.fit.RisingSlope;
import org.hificamsim.profiling.measure.Measurement;
import org.hificamsim.profiling.measure.PipReading;
import org.hificamsim.profiling.report.Claims.Claim;
import org.hificamsim.profiling.report.ModelScores.DetectionAccuracy;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests the report of a fit to 160 synthetic photos. */
class FitReportTest {
  private static final FitSettings SETTINGS =
      new FitSettings(
          5,
          0,
          new SymbolicSettings(100, 5, 0.001, 0, 1),
          SupportVectorSettings.THESIS,
          Optional.empty(),
          Map.of());

  @TempDir static Path folder;
  private static FitResult result;

  @BeforeAll
  static void fitAndWrite() throws IOException {
    result = new Fitting(SETTINGS).fit(new PhotoCamera(0.0224, 0.015, 1296, 864), photos(), 2);
    assertEquals(36, write(result, "test & trial", folder));
  }

  private static int write(FitResult result, String title, Path folder) throws IOException {
    return FitReport.write(folder, result, PipReading.SILHOUETTE, title, "mine");
  }

  @Test
  void containsEveryTableAndFigure() throws IOException {
    String page = Files.readString(folder.resolve("report.html"));
    assertTrue(page.contains("test &amp; trial"));
    for (String table : List.of("Table 4.1", "Table 4.2", "Table 6.1", "Table 6.2", "3.7")) {
      assertTrue(page.contains(table), table);
    }
    for (String figure :
        List.of("4.1", "4.2", "4.3", "4.4", "4.5", "4.7", "5.3", "5.5", "5.7", "6.1", "6.2")) {
      assertTrue(page.contains(">Figure " + figure + ":"), figure);
      for (String format : FigureFile.FORMATS) {
        Path file = folder.resolve("figure-" + figure + "." + format);
        assertTrue(Files.size(file) > 5000, file.toString());
      }
    }
    assertFalse(withoutPictures(page).contains("NaN"), "a number is missing");
  }

  @Test
  void reportIsOneSelfContainedFile() throws IOException {
    String page = Files.readString(folder.resolve("report.html"));
    assertFalse(page.contains(".png\""), "the page refers to a picture file");
    assertFalse(page.contains("http"), "the page refers to the network");
    long pictures =
        page.lines().mapToLong(line -> line.split("data:image/png", -1).length - 1).sum();
    assertEquals(3 + 1 + 11, pictures);
  }

  @Test
  void ownNumbersAndRecommendationComeFirst() throws IOException {
    String page = Files.readString(folder.resolve("report.html"));
    String first = page.substring(0, page.indexOf("<table>"));
    assertTrue(first.contains("-pinhole: on objects that it has not seen"), first);
    assertTrue(page.indexOf("Models g(f)") < page.indexOf("Beside the thesis"));
    assertTrue(page.indexOf("Table 4.1") > page.indexOf("Beside the thesis"));
    assertTrue(page.contains("160 photos of 4 objects."), "the counts are missing");
    assertFalse(
        withoutPictures(page).matches("(?s).*\\b[Oo]urs?\\b.*"), "the page calls data ours");
  }

  @Test
  void judgesChancesOnUnseenPhotos() throws IOException {
    String page = Files.readString(folder.resolve("report.html"));
    assertTrue(page.contains("constant, false alarms count"), "the former scatter is missing");
    assertTrue(page.contains("log loss"), "the reason of the choice is missing");
    assertTrue(Files.exists(folder.resolve("reliability.png")));
    String lens = Recommendation.lens(result);
    assertTrue(page.contains(lens.substring(0, 60)), lens);
    assertTrue(
        lens.startsWith("In your photos PIP grows with the focal length to the power 1.96 ["),
        lens);
    assertTrue(lens.contains("it is 1.32"), lens);
  }

  @Test
  void showsUnknownIntervalAsDash() {
    assertEquals("-", CellText.span(Double.NaN, Double.NaN));
    assertEquals("-1.00 to 2.50", CellText.span(-1, 2.5));
  }

  @Test
  void reportsConfidenceThatRisesOnlyWithTheLogarithm() {
    assertEquals("surely", OwnTables.rises(new RisingSlope(0.2, 0.1, 0.3, true)));
    assertEquals(
        "surely with the logarithm", OwnTables.rises(new RisingSlope(0.2, -0.1, 0.3, true)));
    assertEquals("not surely: refused", OwnTables.rises(new RisingSlope(0.2, -0.1, 0.3, false)));
  }

  @Test
  void figure61AndModelScoresContainEveryF() {
    for (String f : List.of("pinhole", "power", "lin", "svr-lin", "sr", "svr-rbf")) {
      assertTrue(result.features().stream().anyMatch(feature -> feature.name().equals(f)), f);
      assertTrue(
          ModelScores.of(result, "orb").stream()
              .anyMatch(modelScores -> modelScores.model().equals(f)),
          f);
    }
    assertEquals(6 * 3, new ReportFigures(result).figure("6.1", "").panels().size());
  }

  @Test
  void formatsNumbersNearZeroAndCounts() {
    assertEquals("0.000", CellText.fixed(-1e-9, 3));
    assertEquals("-0.001", CellText.fixed(-1e-3, 3));
    assertEquals("0", CellText.fixed(-0.0, 0));
    assertEquals("1 photo", org.hificamsim.core.Texts.counted(1, "photo"));
    assertEquals("0 lenses", org.hificamsim.core.Texts.counted(0, "lens"));
  }

  @Test
  void figuresDoNotDependOnEarlierFigures() {
    ReportFigures figures = new ReportFigures(result);
    byte[] residuals = png(figures.figure("4.4", "residuals"));
    figures.figure("4.2", "densities");
    assertArrayEquals(residuals, png(figures.figure("4.4", "residuals")));
  }

  private static byte[] png(Figure figure) {
    return FigureFile.draw(figure, Optional.empty()).files().get(0);
  }

  /**
   * Computed by hand: 2 of 3 detected photos and 1 of 2 undetected ones are predicted correctly.
   */
  @Test
  void accuracyIsBalanced() {
    DetectionAccuracy decisions = new DetectionAccuracy(0.5);
    double[] measured = {0.9, 0.5, 0.7, 0.1, 0.2};
    double[] predicted = {0.6, 0.4, 0.5, 0.9, 0.1};
    assertEquals((2.0 / 3 + 1.0 / 2) / 2, decisions.accuracy(measured, predicted), 1e-15);
    assertEquals(0.6, decisions.detected(measured), 1e-15);
    assertTrue(Double.isNaN(decisions.accuracy(new double[] {0.9}, new double[] {0.9})));
  }

  @Test
  void reportsDetectorsWithoutPublishedNumbers() throws IOException {
    List<Measurement> rows =
        new Photos().detector("onnx-tiny-0", p -> 0.9 * p / (p + 0.01)).scatter(0.02, 0.02).take(1);
    FitResult own = new Fitting(SETTINGS).fit(Photos.CAMERA, rows, 2);
    Path page = Files.createDirectories(folder.resolve("onnx-tiny-0"));
    write(own, "people", page);
    String text = Files.readString(page.resolve("report.html"));
    assertTrue(text.contains("Take onnx-tiny-0-pinhole"), text.substring(0, 1500));
    assertFalse(text.contains("0 of 0"), "a count of nothing");
    assertFalse(text.contains("(-)"), "brackets around nothing");
    assertFalse(withoutPictures(text).contains("NaN"));
  }

  /** Returns few photos, for tests that do not depend on statistics. */
  private static Photos fewPhotos() {
    return new Photos().objects(4).lenses(0.010, 0.050);
  }

  /** Returns a page without its embedded pictures, whose bytes may contain any text. */
  private static String withoutPictures(String page) {
    return page.replaceAll("base64,[^\"]*", "");
  }

  @Test
  void rejectsDetectorOfNoise() throws IOException {
    List<Measurement> rows = fewPhotos().detector("noise", p -> 0.2).scatter(0.02, 0.05).take(1);
    FitResult own = new Fitting(SETTINGS).fit(Photos.CAMERA, rows, 2);
    Path page = Files.createDirectories(folder.resolve("noise"));
    try (OutputFolder earlier = new OutputFolder(page)) {
      earlier.write("models/noise-lin.json", "of an earlier fit");
      earlier.commit(List.of());
    }
    assertEquals(0, write(own, "noise", page));
    Path refused = page.resolve("models/noise-lin.json");
    assertFalse(Files.exists(refused), "a refused model keeps no file");
    String text = Files.readString(page.resolve("report.html"));
    assertTrue(text.contains("No model of noise is one"), text.substring(0, 1500));
  }

  @Test
  void reportsOneObjectAndOneLens() throws IOException {
    List<Measurement> rows =
        new Photos().objects(1).lenses(0.05).detector("orb", p -> 0.1 + 0.5 * p).take(1);
    FitResult own = new Fitting(SETTINGS).fit(Photos.CAMERA, rows, 2);
    Path page = Files.createDirectories(folder.resolve("one"));
    assertTrue(write(own, "one", page) >= 8);
    assertTrue(Files.readString(page.resolve("report.html")).contains("10 photos of 1 object."));
    assertTrue(Files.exists(page.resolve("models/orb-pinhole.json")));
  }

  @Test
  void showsPublishedNumbersNextToOwn() throws IOException {
    String page = Files.readString(folder.resolve("report.html"));
    for (String number : List.of("(0.77)", "(5.97)", "(0.71)", "(8.79)", "0.835", "-18.82*z")) {
      assertTrue(page.contains(number), number);
    }
  }

  @Test
  void everyModelFilePredictsTheFittedConfidence() {
    ZoomLevel zoom = new ZoomLevel(5, 2.5, 7.5, Double.NaN, 2 * Math.PI);
    for (String detector : result.detectors()) {
      for (String f : List.of("lin", "svr-lin", "svr-rbf", "sr", "power", "pinhole")) {
        HiFiDetection model =
            (HiFiDetection)
                ModelFiles.read(folder.resolve("models/" + detector + "-" + f + ".json"));
        double pip = result.feature(f).fit().f().pip(0.3, 4, 0.0425);
        assertEquals("mine:" + detector + "-" + f, model.name());
        assertEquals(
            result.model(detector, f).chosen().g().confidence(pip),
            model.confidence(0.3, 4, 0, zoom));
      }
    }
  }

  private static Measurement byOrbAlone(Measurement photo) {
    return new Measurement(
        photo.image(),
        photo.object(),
        photo.size(),
        photo.distance(),
        photo.focalLength(),
        photo.pip(),
        Map.of("orb", photo.confidence("orb")));
  }

  @Test
  void fitsTheSameOnAnyNumberOfThreads() {
    List<Measurement> orb = result.measurements().stream().map(FitReportTest::byOrbAlone).toList();
    FitResult again = new Fitting(SETTINGS).fit(result.camera(), orb, 1);
    assertEquals(result.line("orb", "sr"), again.line("orb", "sr"));
    for (FeatureResult f : result.features()) {
      assertEquals(f.fit(), again.feature(f.name()).fit());
      assertEquals(
          result.model("orb", f.name()).chosen().g(), again.model("orb", f.name()).chosen().g());
    }
  }

  @Test
  void camSimConfidenceGrowsWithTheFocalLength() {
    double[] values = result.predictor(FitResult.CAMSIM);
    for (int i = 0; i < values.length; i++) {
      double z = result.measurements().get(i).focalLength();
      // Four zooms: 10, 24, 50 and 85 mm; 85 mm gets the confidence of radius 10 out of 85.
      double radius = z == 0.085 ? 0.010 : z == 0.050 ? 0.024 : z == 0.024 ? 0.050 : 0.085;
      assertEquals(0.95 * (1 - radius / 0.085) - 0.15, values[i], 1e-12);
    }
  }

  @Test
  void scoresCamSimModelsBeforeEveryF() {
    List<ModelScores> scores = ModelScores.of(result, "orb");
    assertEquals(
        List.of(
            "geometric", "camsim-standard", "pinhole", "power", "lin", "svr-lin", "sr", "svr-rbf"),
        scores.stream().map(ModelScores::model).toList());
    assertTrue(scores.get(0).fit().unseen().r2() <= 0, "the mean of the others explains nothing");
    assertEquals(0.5, scores.get(0).accuracy(), "it guesses");
    assertTrue(scores.get(2).fit().unseen().r2() > 0.9);
    assertTrue(scores.get(2).accuracy() > 0.8, "" + scores.get(2));
    assertTrue(scores.get(1).fit().unseen().r2() < 0.5);
  }

  @Test
  void realPhotosDoNotFollowThePinhole() {
    HeldOut heldOut = HeldOut.of(PipReading.RECTANGLE);
    assertEquals(6, heldOut.photos().size());
    SimpleRegression line = new SimpleRegression();
    heldOut
        .photos()
        .forEach(photo -> line.addData(Math.log(photo.focalLength()), Math.log(photo.pip())));
    assertEquals(1.316, line.getSlope(), 0.001);
    assertTrue(heldOut.remark().contains("to the power 1.32,"), heldOut.remark());
  }

  @Test
  void measuresTheBallByTheSamePixelsAsThePhotos() throws IOException {
    HeldOut rectangles = HeldOut.of(PipReading.RECTANGLE);
    HeldOut silhouettes = HeldOut.of(PipReading.SILHOUETTE);
    assertEquals(
        2904.0 * 2850 / (5184 * 3456), rectangles.photos().get(0).pip(), 1e-15, "as published");
    for (int i = 0; i < rectangles.photos().size(); i++) {
      assertEquals(
          Math.log10(4 / Math.PI),
          silhouettes.photos().get(i).response() - rectangles.photos().get(i).response(),
          1e-12);
    }
    assertTrue(Files.readString(folder.resolve("report.html")).contains("the ball's disc"));
  }

  @Test
  void judgesStatementsOfChapters4To6() throws IOException {
    List<Claim> claims = new Claims(result).all();
    assertEquals(1 + 4 + 4 + 1 + 4 + 3 + 3 + 3 + 3 + 1, claims.size());
    List<String> columns = List.of("source", "claim", "published", "value", "verdict");
    assertEquals(
        claims.size(),
        CsvReader.open(folder.resolve(Claims.FILE), "claims").readAll(columns).rows().size());
    List<String> published = claims.stream().map(Claim::published).toList();
    assertTrue(published.containsAll(List.of("0.86", "0.73", "0.92", "0.60", "0.09")));
    assertTrue(published.containsAll(List.of("svr-rbf > lin > sr", "orb > surf > sift")));
    for (Claim claim : claims) {
      if (claim.text().contains("more of")) {
        assertTrue(claim.reproduced(), claim.text());
      }
    }
  }

  @Test
  void sharesWithinFiveHundredthsAreReproduced() {
    assertTrue(Claims.isReproduced(0.65 - 0.60));
    assertFalse(Claims.isReproduced(0.66 - 0.60));
  }

  /** SSE / (1 - R2) is the variation of one detector's confidences for any predictor. */
  @Test
  void publishedScoresAreConsistentExceptOrbOnMeasuredPip() {
    for (String detector : List.of("orb", "sift", "surf")) {
      double total = total(PublishedTables.line(detector, "lin"));
      for (Map<String, String> row :
          List.of(
              PublishedTables.line(detector, "svr-rbf"),
              PublishedTables.line(detector, "sr"),
              PublishedTables.camSimLine(detector))) {
        assertEquals(1, total(row) / total, 0.06, detector);
      }
      double measured = total(PublishedTables.groundTruthLine(detector)) / total;
      assertEquals(detector.equals("orb") ? 1.11 : 1, measured, 0.01, detector);
    }
  }

  private static double total(Map<String, String> row) {
    return Double.parseDouble(row.get("sse")) / (1 - Double.parseDouble(row.get("r2")));
  }

  @Test
  void publishedTablesEqualTheReferences() throws IOException {
    try (Stream<Path> files = Files.list(Reference.file("published"))) {
      List<Path> tables = files.toList();
      assertEquals(6, tables.size());
      for (Path table : tables) {
        try (InputStream ours =
            PublishedTables.class.getResourceAsStream("" + table.getFileName())) {
          assertArrayEquals(Files.readAllBytes(table), ours.readAllBytes(), "" + table);
        }
      }
    }
  }

  @Test
  void skewnessIsZeroOnlyForSymmetry() {
    assertEquals(0, Variable.skewness(new double[] {1, 2, 3}), 1e-12);
    // Mean 1, v = 4: (3 * (-1)^3 + 3^3) / (3 * 8)
    assertEquals(1, Variable.skewness(new double[] {0, 0, 0, 4}), 1e-12);
  }

  private static List<Measurement> photos() {
    Random random = new Random(3);
    List<Measurement> photos = new ArrayList<>();
    for (double q : new double[] {0.1, 0.2, 0.3, 0.6}) {
      for (double z : new double[] {0.010, 0.024, 0.050, 0.085}) {
        for (int d = 1; d <= 10; d++) {
          double side = z * q / d;
          double pip = Math.min(1, side * side / (0.0224 * 0.015));
          Map<String, Double> confidences = new LinkedHashMap<>();
          for (String detector : List.of("orb", "sift", "surf")) {
            double noise = 0.01 * random.nextGaussian();
            confidences.put(detector, Math.max(0, Math.min(1, 0.6 * pip + 0.05 + noise)));
          }
          photos.add(new Measurement(q + "/" + z + "/" + d, "o" + q, q, d, z, pip, confidences));
        }
      }
    }
    return photos;
  }
}
