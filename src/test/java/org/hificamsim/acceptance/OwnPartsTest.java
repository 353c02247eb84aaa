package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that the model, movement and listener of {@code examples/} are found in their jars. */
class OwnPartsTest {
  private static final int STEPS = 20;

  @TempDir Path folder;

  @Test
  void detectionModelIsFoundByName() throws Exception {
    run("own-detection", Cli.scenario("lattice-random"), "--detection", "fog");
    String summary = Files.readString(folder.resolve("out/summary.json"));
    assertTrue(summary.contains("\"fog\""), summary);
    assertTrue(summary.contains("0.02"), "its own threshold: " + summary);
  }

  @Test
  void movementNamedInScenarioIsFound() throws Exception {
    Path scenario = folder.resolve("circling.xml");
    String text = Files.readString(Cli.scenario("lattice-random"));
    Files.writeString(scenario, text.replace("speed=\"1.0\"", "speed=\"1.0\" move=\"Circling\""));
    run("own-movement", scenario, "--record");
    List<double[]> path =
        Files.readAllLines(folder.resolve("out/targets.csv")).stream()
            .map(line -> line.split(",", -1))
            .filter(row -> row[2].equals("1.0"))
            .map(row -> new double[] {Double.parseDouble(row[3]), Double.parseDouble(row[4])})
            .toList();
    assertEquals(STEPS, path.size());
    assertCircle(path, 2);
  }

  @Test
  void listenerIsFoundByName() throws Exception {
    Cli run =
        run(
            "own-listener",
            Cli.scenario("lattice-random"),
            "--detection",
            "camsim-range",
            "--policy",
            "zoom-in",
            "--listener",
            "longest-gap");
    assertTrue(
        run.out().contains("longest gap in coverage: " + longestGap() + " steps"), run.out());
    assertTrue(longestGap() > 0);
  }

  private Cli run(String example, Path scenario, Object... words) throws Exception {
    Object[] fixed = {"run", scenario, "--steps", STEPS, "--out", folder.resolve("out")};
    Object[] all = Arrays.copyOf(fixed, fixed.length + words.length);
    System.arraycopy(words, 0, all, fixed.length, words.length);
    Cli run = Example.pack(example, folder).run(all);
    assertEquals(0, run.exit(), run.out());
    return run;
  }

  /** Requires that the circle through any three points of a path in a row has a radius. */
  private static void assertCircle(List<double[]> path, double radius) {
    for (int i = 2; i < path.size(); i++) {
      double a = distance(path.get(i - 2), path.get(i - 1));
      double b = distance(path.get(i - 1), path.get(i));
      double c = distance(path.get(i - 2), path.get(i));
      double half = (a + b + c) / 2;
      double area = Math.sqrt(half * (half - a) * (half - b) * (half - c));
      assertEquals(radius, a * b * c / (4 * area), 1e-9);
    }
  }

  private static double distance(double[] p, double[] q) {
    return Math.hypot(p[0] - q[0], p[1] - q[1]);
  }

  private int longestGap() throws IOException {
    int gap = 0;
    int longest = 0;
    for (String line : Files.readAllLines(folder.resolve("out/steps.csv"))) {
      gap = line.split(",", -1)[2].equals("0") ? gap + 1 : 0;
      longest = Math.max(longest, gap);
    }
    return longest;
  }
}
