package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests {@code profile}: from an empty folder to a run with a fitted model. */
class ProfileCommandTest {
  @TempDir Path folder;

  @Test
  void labPhotosBecomeModelsThatRun() throws IOException {
    Path lab =
        Cli.lab(
            folder, "--scale 0.08 --objects 3 --focal-lengths 0.010,0.035,0.085 --distances 1,2,5");
    Cli measured = assertDone(Cli.run("profile", "measure", lab));
    assertTrue(measured.out().contains("photos measured"), measured.out());
    Cli fitted =
        assertDone(
            Cli.run(
                "profile", "fit", lab, "--population", 60, "--generations", 3, "--restarts", 2));
    assertTrue(fitted.out().contains(" models in "), fitted.out());
    assertTrue(fitted.out().contains("Take "), fitted.out());
    for (String model : List.of("orb-svr-rbf", "sift-pinhole", "surf-lin", "orb-power-gt")) {
      Path file = lab.resolve("models").resolve(model + ".json");
      Path out = folder.resolve(model);
      assertDone(
          Cli.run(
              "run",
              Cli.scenario("lattice-random"),
              "--steps",
              5,
              "--detection",
              file,
              "--out",
              out));
      assertTrue(Files.readString(out.resolve("summary.json")).contains("lab:" + model));
    }
    Browser browser = Browser.shared();
    browser.open(lab.resolve("report.html").toUri().toString());
    Accessibility.checkEverywhere(browser);
  }

  /** The confidences of twelve photos alternate and do not depend on the distance. */
  @Test
  void rejectsNoiseAndWritesNoModels() throws IOException {
    Cli fitted = fit((row, pip) -> row % 2 == 0 ? 0.1 : 0.3);
    assertEquals(2, fitted.exit(), fitted.err());
    assertTrue(
        fitted.err().contains("warning: orb-pinhole is no detector: its slope on PIP is"),
        fitted.err());
    assertTrue(fitted.err().contains("no confidence surely rises with PIP"), fitted.err());
    assertTrue(Files.notExists(folder.resolve("models")));
    assertTrue(Files.exists(folder.resolve("report.html")));
  }

  @Test
  void fitsSingleObjectAndWarnsOfOtherSizes() throws IOException {
    assertDone(fit((row, pip) -> 0.9 * pip / (pip + 0.01)));
    Cli run =
        assertDone(
            Cli.run(
                "run",
                Cli.scenario("lattice-random"),
                "--steps",
                5,
                "--detection",
                folder.resolve("models/orb-pinhole.json"),
                "--out",
                folder.resolve("run")));
    assertTrue(run.err().contains("'lab:orb-pinhole' was not fitted on what is asked"), run.err());
    assertTrue(run.err().contains("(fitted on 0.3)"), run.err());
    Cli shipped =
        assertDone(
            Cli.run(
                "run",
                Cli.scenario("lattice-random"),
                "--steps",
                5,
                "--detection",
                "hifi:orb-lin"));
    assertFalse(shipped.err().contains("not fitted on"), shipped.err());
  }

  @Test
  void comparesRefitWithShippedModelOfSameName() throws IOException {
    assertDone(fit((row, pip) -> 0.9 * pip / (pip + 0.01)));
    Path file = folder.resolve("models/orb-pinhole.json");
    Path out = folder.resolve("compared");
    assertDone(compare(file + ",lab:orb-pinhole", out));
    String table = Files.readString(out.resolve("summary.csv"));
    assertTrue(table.contains(",lab:orb-pinhole,"), table);
    assertTrue(table.contains("-models-orb-pinhole.json,"), table);
    Cli twice = compare(file + "," + file, folder.resolve("twice"));
    assertEquals(2, twice.exit());
    assertTrue(twice.err().contains("twice"), twice.err());
  }

  private static Cli compare(String detections, Path out) {
    return Cli.run(
        "compare",
        Cli.scenario("lattice-random"),
        "--detections",
        detections,
        "--policies",
        "random",
        "--repeat",
        1,
        "--steps",
        5,
        "--out",
        out);
  }

  @Test
  void modelsTakeThresholdsFromNegatives() throws IOException {
    Files.writeString(
        folder.resolve("thresholds.csv"),
        "detector,threshold,false_alarms,recall\norb,0.123,0,1\n");
    assertDone(fit((row, pip) -> 0.9 * pip / (pip + 0.01)));
    String model = Files.readString(folder.resolve("models/orb-pinhole.json"));
    assertTrue(model.contains("\"threshold\": 0.123"), model);
    assertTrue(model.contains("\"version\": 2"), model);
    assertTrue(Files.readString(folder.resolve("report.html")).contains("orb 0.123"));
  }

  private Cli fit(java.util.function.BiFunction<Integer, Double, Double> confidence)
      throws IOException {
    Files.writeString(
        folder.resolve("camera.json"),
        "{\"sensorWidth\": 0.0224, \"sensorHeight\": 0.015, \"width\": 60, \"height\": 40}");
    StringBuilder table =
        new StringBuilder("image,object,size_m,distance_m,focal_length_m,pip,orb\n");
    for (int row = 0; row < 12; row++) {
      double distance = 1 + row / 2.0;
      double pip = Math.pow(0.05 * 0.3 / distance, 2) / (0.0224 * 0.015);
      table.append(
          "%s.png,ball,0.3,%s,0.05,%s,%s\n"
              .formatted(row, distance, pip, confidence.apply(row, pip)));
    }
    Files.writeString(folder.resolve("measurements.csv"), table.toString());
    return Cli.run("profile", "fit", folder, "--population", 60, "--generations", 3);
  }

  @Test
  void fitsConfidencesOfAnyDetectorWithoutPhotos() throws IOException {
    Path file = confidences("yolo");
    Cli fit = assertDone(fitConfidences(file));
    Path model = folder.resolve("models/yolo-pinhole.json");
    assertTrue(Files.exists(model), fit.out());
    assertTrue(Files.exists(folder.resolve("report.html")));
    assertDone(
        Cli.run(
            "run",
            Cli.scenario("lattice-random"),
            "--steps",
            5,
            "--detection",
            model,
            "--out",
            folder.resolve("out")));
  }

  /** The detector is named after the CSV file. */
  @Test
  void alignsColumnsForLongNames() throws IOException {
    Cli fit = assertDone(fitConfidences(confidences("a-detector-with-a-long-name")));
    List<String> lines = fit.out().lines().limit(6).toList();
    int end = lines.get(0).indexOf(" RMSE") + 5;
    lines.forEach(line -> assertTrue(line.startsWith("  ", end), fit.out()));
  }

  @Test
  void rejectsModelsWithCovariates() throws IOException {
    assertDone(fitConfidences(confidences("yolo")));
    Path model = folder.resolve("models/yolo-pinhole.json");
    String lit = Files.readString(model).replace("\"units\"", "\"covariates\": {},\n  \"units\"");
    Files.writeString(model, lit);
    Cli run = Cli.run("run", Cli.scenario("lattice-random"), "--steps", 5, "--detection", model);
    assertEquals(2, run.exit());
    assertEquals(1, run.err().lines().count(), run.err());
    assertTrue(run.err().contains("covariates is an object, expected none"), run.err());
  }

  /** Writes confidences that depend only on the share of the image that an object fills. */
  private Path confidences(String detector) throws IOException {
    Files.writeString(
        folder.resolve("camera.json"),
        "{\"sensorWidth\": 0.0224, \"sensorHeight\": 0.015, \"width\": 1296, \"height\": 864}");
    StringBuilder table = new StringBuilder("image,q,d,z,confidence,object,light\n");
    for (double q : new double[] {0.2, 0.4, 0.8}) {
      for (double z : new double[] {0.01, 0.035, 0.085}) {
        for (double d = 1; d < 40; d *= 1.5) {
          double pip = Math.pow(q * z / d, 2) / (0.0224 * 0.015);
          double confidence = 0.9 * (1 - Math.exp(-Math.min(1, pip) / 0.01));
          table.append("photo,%s,%s,%s,%s,thing of %s,dim\n".formatted(q, d, z, confidence, q));
        }
      }
    }
    return Files.writeString(folder.resolve(detector + ".csv"), table);
  }

  private Cli fitConfidences(Path confidences) {
    return Cli.run(
        "profile",
        "fit",
        folder,
        "--confidences",
        confidences,
        "--population",
        100,
        "--generations",
        3,
        "--restarts",
        1);
  }

  @Test
  void drawingMatchesKeepsMeasurements() throws IOException {
    Path lab = Cli.lab(folder, "--scale 0.05 --objects 1 --focal-lengths 0.05 --distances 1,2");
    Path table = lab.resolve("measurements.csv");
    String image = "images/matchbox-50mm-01.0m.jpg";
    Cli first = assertDone(Cli.run("profile", "measure", lab, "--picture", image));
    assertTrue(first.out().contains("by OpenCV "), first.out());
    byte[] measured = Files.readAllBytes(table);
    Cli again =
        assertDone(Cli.run("profile", "measure", lab, "--detectors", "orb", "--picture", image));
    assertEquals("1 drawn: " + lab.resolve("matches") + "\n", again.out());
    assertArrayEquals(measured, Files.readAllBytes(table));
  }

  /** Phones append a video to the file of a motion photo. */
  @Test
  void measuresPhotoThatVideoIsAppendedTo() throws IOException {
    Path lab = Cli.lab(folder, "--scale 0.05 --objects 1 --focal-lengths 0.05 --distances 1,2");
    Path table = lab.resolve("measurements.csv");
    Path photo = lab.resolve("images/matchbox-50mm-01.0m.jpg");
    byte[] jpeg = Files.readAllBytes(photo);
    assertDone(Cli.run("profile", "measure", lab, "--detectors", "orb"));
    byte[] measured = Files.readAllBytes(table);
    Files.delete(table);
    byte[] video = "    ftypmp42 ".repeat(9_999).getBytes(StandardCharsets.US_ASCII);
    Files.write(photo, video, StandardOpenOption.APPEND);
    assertDone(Cli.run("profile", "measure", lab, "--detectors", "orb"));
    assertArrayEquals(measured, Files.readAllBytes(table));
    Files.delete(table);
    Files.write(photo, Arrays.copyOf(jpeg, jpeg.length - 100));
    Cli cut = Cli.run("profile", "measure", lab, "--detectors", "orb");
    assertEquals(2, cut.exit());
    assertTrue(cut.err().contains("the file is cut short"), cut.err());
  }

  @Test
  void reportsEveryProblemOfDataSet() throws IOException {
    Files.writeString(
        folder.resolve("camera.json"),
        "{\"sensorWidth\": 0.0224, \"sensorHeight\": 0.015, \"width\": 60, \"height\": 40}");
    Files.writeString(
        folder.resolve("dataset.csv"),
        "image,object,size_m,distance_m,focal_length_m,patch_x,patch_y,patch_width,patch_height\n"
            + "a.jpg,ball,0,1,0.085,10,10,20,30\nb.jpg,ball,0.22,1,0.085,10,10,0,30\n");
    Cli run = Cli.run("profile", "measure", folder);
    assertEquals(2, run.exit());
    assertEquals(5, run.err().lines().count(), run.err());
    run.err()
        .lines()
        .forEach(
            line ->
                assertTrue(
                    line.matches("error: \\Q" + folder + "\\E/dataset.csv:[23]:\\d+: .*"), line));
    assertFalse(Files.exists(folder.resolve("measurements.csv")));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "profile | expected lab, measure, fit",
        "profile lab | --out",
        "profile lab --out DIR --scale 2 | --scale is 2.0, expected a number from 0.02 to 1.0",
        "profile lab --out DIR --distances 0 | --distances is 0.0",
        "profile lab --out DIR --objects 9 | --objects is 9",
        "profile measure DIR | camera.json: no such file",
        "profile measure DIR --detectors yolo | --detectors has 'yolo'",
        "profile measure DIR --detectors haar:nix | --detectors has 'haar:nix'",
        "profile measure DIR --detectors onnx:nix.onnx | nix.onnx: no such file",
        "profile measure DIR --ratio 0 | --ratio is 0.0",
        "profile fit DIR | camera.json: no such file",
        "profile fit DIR --name a/b | --name is 'a/b'",
        "profile fit DIR --folds 1 | --folds is 1",
        "profile fit DIR --restarts 0 | --restarts is 0",
        "profile fit DIR --g spline | g 'spline' is unknown, expected one of line, logistic",
      })
  void rejectsWrongUsageInOneLine(String command, String words) {
    Cli run = Cli.run((Object[]) command.strip().replace("DIR", folder.toString()).split(" "));
    assertEquals(2, run.exit(), run.err());
    assertEquals(1, run.err().lines().count(), run.err());
    assertTrue(run.err().contains(words), run.err());
  }

  @ParameterizedTest
  @ValueSource(
      strings = {
        "orb-lin",
        "orb-svr-rbf",
        "orb-sr",
        "sift-lin",
        "sift-svr-rbf",
        "sift-sr",
        "surf-lin",
        "surf-svr-rbf",
        "surf-sr"
      })
  void runsEveryModelOfTable61(String model) {
    Cli run =
        Cli.run(
            "run",
            Cli.scenario("ring-random"),
            "--steps",
            5,
            "--detection",
            "lab:" + model,
            "--out",
            folder);
    assertDone(run);
  }

  private static Cli assertDone(Cli run) {
    assertEquals(0, run.exit(), run.err());
    return run;
  }
}
