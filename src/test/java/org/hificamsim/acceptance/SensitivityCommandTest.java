package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests {@code sensitivity}. */
class SensitivityCommandTest {
  private static final List<String> PARAMETERS =
      List.of(
          "threshold-hifi",
          "threshold-camsim",
          "targets",
          "gamma",
          "epsilon",
          "k",
          "reward",
          "size",
          "optics",
          "f",
          "g",
          "state",
          "formula",
          "speed",
          "radii",
          "alpha",
          "q0",
          "ties",
          "greedy");

  @TempDir Path folder;

  /** Returns the results of a short sensitivity study. */
  static Results swept() {
    return Results.of("sensitivity", "--steps", 30, "--repeat", 2, "--quiet");
  }

  @Test
  void everySweepIncludesItsDefault() throws IOException {
    Path swept = swept().folder();
    List<String> rows = Files.readAllLines(swept.resolve("sensitivity.csv"));
    for (String parameter : PARAMETERS) {
      assertTrue(
          rows.stream().anyMatch(row -> row.matches(parameter + ",[^,]*,true,all,.*")), parameter);
      assertTrue(Files.size(swept.resolve("sensitivity-" + parameter + ".png")) > 1000);
      assertTrue(Files.size(swept.resolve("sensitivity-" + parameter + ".svg")) > 1000);
    }
    String findings = Files.readString(swept.resolve("sensitivity.md"));
    assertTrue(findings.contains("It holds in"));
    assertTrue(findings.contains("How many settings fit Table 8.1 as well"));
    assertModelsDifferOnlyByFeatureAbstraction(rows);
    assertEverySettingHasItsDistanceFromTable();
  }

  /** Under the default thresholds the detector g cancels out. */
  private static void assertModelsDifferOnlyByFeatureAbstraction(List<String> rows) {
    List<String> own = rows.stream().filter(row -> row.startsWith("g,")).toList();
    assertEquals(3 * 4 * 4, own.size());
    assertEquals(
        own.size() / 3,
        own.stream().map(row -> row.replaceFirst("g,[a-z]+,(true|false),", "")).distinct().count());
    assertTrue(
        4 * 4
            < rows.stream()
                .filter(row -> row.startsWith("f,"))
                .map(row -> row.replaceFirst("f,[-a-z]+,(true|false),", ""))
                .distinct()
                .count());
  }

  private static void assertEverySettingHasItsDistanceFromTable() throws IOException {
    List<String> fits = Files.readAllLines(swept().folder().resolve("fit.csv"));
    assertEquals("parameter,value,default,error_hifi,error_camsim", fits.get(0));
    assertEquals(
        1,
        fits.stream()
            .filter(row -> row.contains(",true,"))
            .map(row -> row.split(",", -1)[3])
            .distinct()
            .count());
    assertTrue(fits.stream().noneMatch(row -> row.startsWith("k,")));
  }

  /** With f_lin, size and threshold change the farthest detected distance of all levels equally. */
  @Test
  void smallerTargetsWithLowerThresholdGiveSameSteps() throws IOException {
    double lower = 0.026 + (0.0441 - 0.026) * Math.pow(10, -2 * (0.66 - 0.45));
    byte[] standard = steps(Cli.scenario("cluster-random"), 0.0441);
    assertArrayEquals(standard, steps(smaller("cluster-random"), lower));
    assertFalse(Arrays.equals(standard, steps(smaller("cluster-random"), 0.0441)));
  }

  private byte[] steps(Path scenario, double threshold) throws IOException {
    Path out = folder.resolve("run-" + threshold);
    Cli run = Cli.run("run", scenario, "--threshold", threshold, "--policy", "sarsa", "--out", out);
    assertEquals(0, run.exit(), run.err());
    return Files.readAllBytes(out.resolve("steps.csv"));
  }

  private Path smaller(String name) throws IOException {
    String scenario = Files.readString(Cli.scenario(name));
    Path file = folder.resolve("small.xml");
    Files.writeString(file, scenario.replace("size=\"0.66\"", "size=\"0.45\""));
    return file;
  }

  /** With smaller targets, policies score less under hi-fi than under CamSim's model. */
  @Test
  void conclusionDependsOnTargetSize() throws IOException {
    Cli run =
        Cli.run(
            "compare",
            smaller("lattice-random"),
            "--policies",
            "optimal,zoom-out,sarsa",
            "--steps",
            3000,
            "--repeat",
            1,
            "--out",
            folder.resolve("out"));
    assertEquals(0, run.exit(), run.err());
    List<String> results = Files.readAllLines(folder.resolve("out/results.csv"));
    for (String row :
        List.of(
            "hifi:orb-lin,optimal,0,738",
            "hifi:orb-lin,zoom-out,0,39",
            "hifi:orb-lin,sarsa,0,281",
            "camsim-range,optimal,0,2311",
            "camsim-range,zoom-out,0,780",
            "camsim-range,sarsa,0,1205")) {
      assertTrue(results.stream().anyMatch(result -> result.startsWith("small," + row + ",")), row);
    }
  }
}
