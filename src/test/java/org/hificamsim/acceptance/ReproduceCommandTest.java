package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** The thesis's table and figures, from the command line. */
class ReproduceCommandTest {
  private static final List<String> FIGURES =
      Stream.of("7.3", "7.4", "7.6", "7.7", "7.8", "7.9", "8.1").map("figure-"::concat).toList();

  /** What {@code reproduction.md} found under every reading that was tried. */
  private static final List<String> ROBUST =
      List.of(
          "baselines-below-greedy",
          "order-of-policies",
          "epsilon-greedy-above-zoom-out",
          "zoom-out-not-optimal",
          "camsim-underestimates");

  @TempDir Path folder;

  @Test
  void writesTheSameFilesOnAnyNumberOfThreads() throws IOException {
    Path one = reproduce("one", 200, 2, 1);
    Path many = reproduce("many", 200, 2, 3);
    for (String file : files()) {
      assertArrayEquals(
          Files.readAllBytes(one.resolve(file)), Files.readAllBytes(many.resolve(file)), file);
    }
    assertEquals(19, Files.readAllLines(one.resolve("table-8.1.csv")).size());
  }

  @Test
  void robustStatementsHoldAtModerateSize() throws IOException {
    List<String> verdicts =
        Files.readAllLines(reproduce("robust", 1500, 4, 2).resolve("verdicts.csv"));
    for (String id : ROBUST) {
      String row =
          verdicts.stream().filter(line -> line.contains("," + id + ",")).findFirst().get();
      assertTrue(row.contains(",reproduced,"), row);
    }
  }

  @Test
  void wrongNumbersAreToldInOneLine() {
    Cli run = Cli.run("reproduce", "--steps", 0, "--out", folder.resolve("none"));
    assertEquals(2, run.exit());
    assertTrue(run.err().contains("--steps is 0"), run.err());
    assertTrue(Files.notExists(folder.resolve("none")));
  }

  private static List<String> files() {
    return Stream.concat(
            Stream.of("table-8.1.csv", "table-8.1.md", "verdicts.csv", "verdicts.md"),
            Stream.concat(FIGURES.stream(), Stream.of("table-8.1"))
                .flatMap(name -> Stream.of(name + ".png", name + ".svg")))
        .toList();
  }

  private Path reproduce(String name, int steps, int repeats, int threads) {
    Path out = folder.resolve(name);
    Cli run =
        Cli.run(
            "reproduce", "--steps", steps, "--repeat", repeats, "--threads", threads, "--out", out);
    assertEquals(0, run.exit(), run.err());
    return out;
  }
}
