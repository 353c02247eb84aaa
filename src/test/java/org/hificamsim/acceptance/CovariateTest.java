package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Aperture, distortion and light, from photos to what a run detects. */
class CovariateTest {
  private static final String SCENARIO =
      """
      <root><simulation min_x="-12" max_x="12" min_y="-12" max_y="12" mount_height="20"%s>
        <cameras><zoom>4 8 12</zoom>
          <camera name="a" x="0" y="0" heading="0" viewing_angle="360" range="8"%s/>
          <camera name="b" x="10" y="0" heading="0" viewing_angle="360" range="8"/>
        </cameras>
        <objects>
          <object features="1" x="1" y="3" heading="30" speed="1" size="0.4"/>
          <object features="2" x="-3" y="5" heading="250" speed="1" size="0.4"/>
        </objects>
      </simulation></root>
      """;

  @TempDir Path folder;

  @Test
  void aRunInTheDarkDetectsLessThanOneInTheLight() throws IOException {
    Path model = lit();
    double dark = detections(model, " light=\"0.5\"", "");
    double mean = detections(model, " light=\"1\"", "");
    double bright = detections(model, " light=\"1.5\"", "");
    assertTrue(dark < mean && mean < bright, dark + " " + mean + " " + bright);
    double oneInTheDark = detections(model, " light=\"1.5\"", " light=\"0.5\"");
    assertTrue(dark < oneInTheDark && oneInTheDark < bright, oneInTheDark + " of " + bright);
  }

  @Test
  void whatAScenarioDoesNotSayIsTheMeanAndOneWarningSaysSo() throws IOException {
    Path model = lit();
    Cli silent = run(model, "", "");
    assertEquals(1, count(silent, "depends on light, which the scenario does not say"));
    assertEquals(1, count(silent, "the mean of its photos counts, 1; expected light=\"...\""));
    assertEquals(0, count(run(model, " light=\"1\"", ""), "depends on"));
    assertEquals(1, count(run(model, "", " light=\"1\""), "of every camera"));
    Path plain = folder.resolve("plain/models/yolo-pinhole.json");
    assertDone(fit("plain", "none"));
    assertFalse(Files.readString(plain).contains("covariates"));
    assertEquals(0, count(run(plain, "", ""), "depends on"));
  }

  @Test
  void lightThatNobodyPhotographedIsWarnedOfAndTheNearestCounts() throws IOException {
    Path model = lit();
    Cli outside = run(model, " light=\"40\"", "");
    assertEquals(1, count(outside, "light 40 (fitted on 0.5 to 1.5)"));
    assertEquals(detections(model, " light=\"1.5\"", ""), detections(model, " light=\"40\"", ""));
    Cli validated = Cli.run("validate", folder.resolve("s.xml"), "--detection", model);
    assertEquals(1, count(validated, "light 40 (fitted on 0.5 to 1.5)"));
  }

  @Test
  void whatHelpsIsFoundAndSaid() throws IOException {
    Cli best = assertDone(fit("best", "best"));
    assertTrue(best.out().contains("yolo depends on light: R2 unseen 1.000"), best.out());
    Path folderOfBest = folder.resolve("best");
    assertTrue(
        Files.readString(folderOfBest.resolve("models/yolo-pinhole.json")).contains("\"light\""));
    String report = Files.readString(folderOfBest.resolve("report.html"));
    assertTrue(report.contains("helps; in the models"));
    assertFalse(assertDone(fit("none", "none")).out().contains("depends on"));
  }

  /** The name of the detector is that of the table. */
  @Test
  void columnsOfTheTableStandBelowEachOtherWhateverTheNames() throws IOException {
    assertDone(fit("columns", "none"));
    Path data = folder.resolve("columns");
    Path longer = data.resolve("a-detector-with-a-long-name.csv");
    Files.move(data.resolve("yolo.csv"), longer);
    Cli fitted =
        assertDone(
            Cli.run(
                "profile",
                "fit",
                data,
                "--confidences",
                longer,
                "--population",
                60,
                "--generations",
                2,
                "--restarts",
                1));
    List<String> lines = fitted.out().lines().limit(6).toList();
    int end = lines.get(0).indexOf(" RMSE") + 5;
    lines.forEach(line -> assertTrue(line.startsWith("  ", end), fitted.out()));
  }

  @Test
  void photosOfTheLaboratoryGiveAModelThatDependsOnTheirLightAndAperture() throws IOException {
    Path lab =
        Cli.lab(
            folder,
            "--scale 0.08 --objects 4 --focal-lengths 0.024,0.085 --distances 1,2,4"
                + " --lighting 0.3 --aperture 2,22");
    assertDone(Cli.run("profile", "measure", lab, "--detectors", "orb"));
    assertDone(
        Cli.run(
            "profile",
            "fit",
            lab,
            "--covariates",
            "aperture,light",
            "--population",
            60,
            "--generations",
            2,
            "--restarts",
            1));
    String model = Files.readString(lab.resolve("models/orb-pinhole.json"));
    assertTrue(model.contains("\"aperture\": {\n      \"weight\": "), model);
    assertTrue(model.contains("\"least\": 2.0,\n      \"most\": 22.0"), model);
    assertTrue(model.contains("\"light\": {"), model);
    Cli run = run(lab.resolve("models/orb-pinhole.json"), "", "");
    assertEquals(1, count(run, "depends on aperture and light, which the scenario does not say"));
  }

  @Test
  void theSameScenarioInAnotherLightIsAnotherRun() throws IOException {
    Path model = lit();
    assertDone(compare(model, " light=\"0.5\""));
    String dark = Files.readString(folder.resolve("compared/results.csv"));
    assertDone(compare(model, " light=\"1.5\""));
    String bright = Files.readString(folder.resolve("compared/results.csv"));
    assertNotEquals(dark, bright);
    assertDone(compare(model, " light=\"0.5\""));
    assertEquals(dark, Files.readString(folder.resolve("compared/results.csv")));
  }

  private Cli compare(Path model, String attributes) throws IOException {
    return Cli.run(
        "compare",
        scenario(attributes, ""),
        "--detections",
        model,
        "--policies",
        "zoom-out",
        "--threshold",
        0.3,
        "--repeat",
        1,
        "--steps",
        20,
        "--resume",
        "--out",
        folder.resolve("compared"));
  }

  private Path lit() throws IOException {
    assertDone(fit("lit", "light"));
    return folder.resolve("lit/models/yolo-pinhole.json");
  }

  /** Confidences of a detector that sees half as much in half of the light. */
  private Cli fit(String name, String covariates) throws IOException {
    Path data = Files.createDirectories(folder.resolve(name));
    Files.writeString(
        data.resolve("camera.json"),
        "{\"sensorWidth\": 0.0224, \"sensorHeight\": 0.015, \"width\": 1296, \"height\": 864}");
    StringBuilder table = new StringBuilder("image,q,d,z,confidence,object,light,aperture\n");
    int photo = 0;
    for (double q : new double[] {0.2, 0.4, 0.8}) {
      for (double z : new double[] {0.01, 0.035, 0.085}) {
        for (double d = 1; d < 40; d *= 1.4) {
          double light = 0.5 + photo % 3 / 2.0;
          double share = Math.min(1, Math.pow(q * z / d, 2) / (0.0224 * 0.015));
          double confidence = 0.9 * (1 - Math.exp(-share * Math.exp(1.4 * (light - 1)) / 0.01));
          table.append(
              String.format(
                  Locale.ROOT,
                  "photo,%s,%s,%s,%s,thing of %s,%s,%s%n",
                  q,
                  d,
                  z,
                  confidence,
                  q,
                  light,
                  1 + photo % 5));
          photo++;
        }
      }
    }
    Path file = data.resolve("yolo.csv");
    Files.writeString(file, table);
    return Cli.run(
        "profile",
        "fit",
        data,
        "--confidences",
        file,
        "--covariates",
        covariates,
        "--g",
        "saturating-exponential",
        "--population",
        60,
        "--generations",
        2,
        "--restarts",
        1);
  }

  private double detections(Path model, String attributes, String ofCamera) throws IOException {
    assertDone(run(model, attributes, ofCamera));
    try (Stream<String> rows = Files.lines(folder.resolve("run/steps.csv"))) {
      return rows.skip(1).mapToDouble(row -> Double.parseDouble(row.split(",")[7])).sum();
    }
  }

  private Cli run(Path model, String attributes, String ofCamera) throws IOException {
    return assertDone(
        Cli.run(
            "run",
            scenario(attributes, ofCamera),
            "--policy",
            "zoom-out",
            "--threshold",
            0.3,
            "--steps",
            40,
            "--detection",
            model,
            "--out",
            folder.resolve("run")));
  }

  private Path scenario(String attributes, String ofCamera) throws IOException {
    Path file = folder.resolve("s.xml");
    return Files.writeString(file, SCENARIO.formatted(attributes, ofCamera));
  }

  private static long count(Cli run, String words) {
    return Stream.concat(run.err().lines(), run.out().lines())
        .filter(line -> line.contains(words))
        .count();
  }

  private static Cli assertDone(Cli run) {
    assertEquals(0, run.exit(), run.err());
    return run;
  }
}
