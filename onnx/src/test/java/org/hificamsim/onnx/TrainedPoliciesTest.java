package org.hificamsim.onnx;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.io.IOException;
import java.io.PrintWriter;
import java.io.StringWriter;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import org.hificamsim.cli.Main;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Compares the shipped network, which imitate.py and improve.py trained, with its scores in JAX.
 */
class TrainedPoliciesTest {
  private static final Path TRAINED =
      Path.of(System.getProperty("hificamsim.root"), "python/examples/trained");
  private static final String TRAINING = "mappo-0";
  private static final double ROUNDING = 0.5e-3;

  @TempDir Path folder;

  /** The scores in scores.csv are those of the same network in JAX, as measure.py computes them. */
  @ParameterizedTest
  @ValueSource(strings = {"passage-v1", "mate-4v8-9-v1"})
  void shippedNetworkScoresInBenchmarkAsMeasuredInJax(String task) throws IOException {
    double measured =
        Files.readAllLines(TRAINED.resolve("scores.csv")).stream()
            .filter(row -> row.startsWith(TRAINING + "," + task + ","))
            .mapToDouble(row -> Double.parseDouble(row.substring(row.lastIndexOf(',') + 1)))
            .average()
            .orElseThrow();
    assertEquals(measured, score(task), 1.1 * ROUNDING);
  }

  /** The mean score of the testing episodes, with the three digits that the benchmark prints. */
  private double score(String task) {
    StringWriter out = new StringWriter();
    StringWriter errors = new StringWriter();
    String[] words = {
      "benchmark",
      "run",
      "--policy",
      "onnx:" + TRAINED.resolve("views.onnx"),
      "--tasks",
      task,
      "--out",
      folder.resolve("entry").toString()
    };
    int exit = Main.execute(new PrintWriter(out), new PrintWriter(errors, true), words);
    assertEquals(0, exit, errors.toString());
    Matcher mean = Pattern.compile(task + " +(-?[0-9.]+) \\[").matcher(out.toString());
    return mean.results().mapToDouble(found -> Double.parseDouble(found.group(1))).sum();
  }
}
