package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.concurrent.TimeUnit;
import java.util.stream.Stream;
import org.hificamsim.core.program.PythonInterpreter;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests what {@code compare} writes, which depends only on the seeds. */
class CompareCommandTest {
  private static final String JOURNAL = ".compare.journal";

  @TempDir static Path shared;
  private static Path compared;

  @TempDir Path folder;

  @BeforeAll
  static void compareOnOneThread() {
    compared = shared.resolve("one");
    Cli compare = Cli.run(words(compared, 100, 4, "--threads", 1));
    assertEquals(0, compare.exit(), compare.err());
  }

  @Test
  void quietPrintsOnlyErrors() {
    Cli compare =
        Cli.run(
            "compare",
            Cli.scenario("ring-random"),
            "--steps",
            5,
            "--repeat",
            2,
            "--quiet",
            "--out",
            folder);
    assertEquals(new Cli(0, "", ""), compare);
    assertEquals(new Cli(0, "", ""), SensitivityCommandTest.swept().cli());
  }

  @Test
  void writesRowsByScenarioDetectionPolicyAndSeed() throws IOException {
    List<String> rows = Files.readAllLines(compared.resolve("results.csv"));
    assertEquals(
        "scenario,detection,policy,seed,performance,proportion_of_optimal,"
            + "covered_0,covered_1,covered_k,optimum,objective,score,proportion_of_reachable,mean_score",
        rows.get(0));
    List<String> expected = new ArrayList<>();
    for (String scenario : List.of("lattice-random", "cluster-scripted")) {
      for (String detection : List.of("camsim-range", "hifi:orb-lin")) {
        for (String policy : List.of("zoom-out", "epsilon-greedy:epsilon=0.2", "fixed:1")) {
          for (int seed = 5; seed < 9; seed++) {
            expected.add(scenario + "," + detection + "," + policy + "," + seed + ",");
          }
        }
      }
    }
    assertEquals(expected.size(), rows.size() - 1);
    for (int i = 0; i < expected.size(); i++) {
      assertTrue(rows.get(i + 1).startsWith(expected.get(i)), rows.get(i + 1));
    }
  }

  @Test
  void rowEqualsRunOfItsSeed() throws IOException {
    Cli.run(
        "run",
        Cli.scenario("cluster-scripted"),
        "--policy",
        "epsilon-greedy:epsilon=0.2",
        "--steps",
        100,
        "--seed",
        6,
        "--out",
        folder.resolve("run"));
    String row =
        Files.readAllLines(compared.resolve("results.csv")).stream()
            .filter(line -> line.startsWith("cluster-scripted,hifi:orb-lin,epsilon-greedy"))
            .skip(1)
            .findFirst()
            .orElseThrow();
    long sum =
        Files.readAllLines(folder.resolve("run/steps.csv")).stream()
            .skip(1)
            .mapToLong(line -> Long.parseLong(line.split(",")[2]))
            .sum();
    assertEquals("6", row.split(",")[3]);
    assertEquals(sum, Long.parseLong(row.split(",")[4]));
  }

  @Test
  void rejectsSecondComparisonInSameFolder() throws Exception {
    Process first =
        Java.main(System.getProperty("java.class.path"), words(folder, 200_000, 20, "--resume"));
    while (first.isAlive() && journalled(folder) == 0) {
      TimeUnit.MILLISECONDS.sleep(2);
    }
    Cli second = Cli.run(words(folder, 10, 1));
    first.destroyForcibly().waitFor();
    assertEquals(2, second.exit(), second.err());
    assertTrue(second.err().contains("is in use by another run"), second.err());
  }

  /** Each camera chooses its last view, as zoom-out does. */
  @Test
  void comparesPolicyOfPythonFile() throws Exception {
    String python = PythonInterpreter.find().executable().toString();
    Process numpy = new ProcessBuilder(python, "-c", "import numpy").start();
    assumeTrue(numpy.waitFor() == 0, "'" + python + "' has no numpy");
    Path policy =
        Files.writeString(
            folder.resolve("widest.py"),
            "def policy(observations, masks):\n    return [len(mask) - 1 for mask in masks]\n");
    Object[] words = words(folder.resolve("out"), 10, 2);
    words[Arrays.asList(words).indexOf("--policies") + 1] = "zoom-out,python:" + policy;
    Cli compare = Cli.run(words);
    assertEquals(0, compare.exit(), compare.err());
    List<String> rows = Files.readAllLines(folder.resolve("out/results.csv"));
    List<String> widest = rows.stream().filter(row -> row.contains("widest.py")).toList();
    List<String> zoomOut = rows.stream().filter(row -> row.contains(",zoom-out,")).toList();
    assertEquals(8, widest.size(), "scenarios, detections and seeds");
    for (int i = 0; i < widest.size(); i++) {
      assertEquals(zoomOut.get(i), widest.get(i).replace("python:" + policy, "zoom-out"));
    }
  }

  @Test
  void recordsEverySettingOfEveryCase() throws IOException {
    String settings = Files.readString(compared.resolve("settings.json"));
    assertEquals(12 + 4, settings.split("\"threshold\"").length - 1);
    assertTrue(settings.contains("\"epsilon-greedy:epsilon=0.2\""), settings);
  }

  @Test
  void thresholdAppliesToDetectionsWithoutOne() throws IOException {
    String detections = "camsim-range,camsim-range@0.45,geometric@0.1";
    Object[] words = words(folder, 10, 1, "--threshold", 0.2);
    words[Arrays.asList(words).indexOf("--detections") + 1] = detections;
    assertEquals(0, Cli.run(words).exit());
    List<String> found = new ArrayList<>();
    for (JsonNode plan : new ObjectMapper().readTree(folder.resolve("settings.json").toFile())) {
      found.add(plan.get("detection").asText() + " " + plan.get("threshold").asDouble());
    }
    assertEquals(
        List.of("camsim-range 0.2", "camsim-range@0.45 0.45", "geometric@0.1 0.1"),
        found.stream().distinct().toList());
    String rows = Files.readString(folder.resolve("results.csv"));
    assertTrue(rows.contains("\ncluster-scripted,camsim-range@0.45,zoom-out,5,"), rows);
  }

  @Test
  void noPolicyBeatsTheOptimum() throws IOException {
    for (String row : Files.readAllLines(compared.resolve("results.csv")).subList(1, 49)) {
      String proportion = row.split(",", -1)[5];
      assertTrue(proportion.isEmpty() || Double.parseDouble(proportion) <= 1, row);
    }
  }

  @ParameterizedTest
  @CsvSource({"2", "5"})
  void writesSameBytesOnAnyNumberOfThreads(int threads) throws IOException {
    Cli.run(words(folder, 100, 4, "--threads", threads));
    assertSameFiles(compared, folder);
  }

  @Test
  void repeatedlyKilledComparisonWritesSameBytes() throws Exception {
    Path whole = folder.resolve("whole");
    Path killed = folder.resolve("killed");
    Object[] work = words(whole, 1_500, 8, "--threads", 2);
    assertEquals(0, Cli.run(work).exit());
    Object[] again = words(killed, 1_500, 8, "--threads", 2, "--resume");
    int kills = 0;
    long finished = 0;
    for (int round = 0; round < 3; round++) {
      Process process = Java.main(System.getProperty("java.class.path"), again);
      long before = finished;
      while (process.isAlive() && (finished = journalled(killed)) <= before + 5) {
        TimeUnit.MILLISECONDS.sleep(2);
      }
      if (process.isAlive()) {
        process.destroyForcibly().waitFor();
        kills++;
        assertFalse(Files.exists(killed.resolve("results.csv")), "results before the end");
      }
    }
    assertTrue(kills >= 2, kills + " kills");
    Files.write(
        killed.resolve(JOURNAL),
        "{\"key\":\"half a li".getBytes(java.nio.charset.StandardCharsets.UTF_8),
        java.nio.file.StandardOpenOption.APPEND);
    assertEquals(0, Cli.run(again).exit());
    assertSameFiles(whole, killed);
    assertFalse(Files.exists(killed.resolve(JOURNAL)));
  }

  @Test
  void onlyResumeReusesFinishedRuns() throws IOException {
    Path out = folder.resolve("out");
    Files.createDirectories(out);
    Files.writeString(out.resolve(JOURNAL), "nothing of use\n");
    assertEquals(0, Cli.run(words(out, 20, 1, "--resume")).exit());
    Files.writeString(out.resolve(JOURNAL), "nothing of use\n");
    assertEquals(0, Cli.run(words(out, 20, 1)).exit());
    assertFalse(Files.exists(out.resolve(JOURNAL)));
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--detections geometric,nothing | unknown detection 'nothing'",
        "--detections geometric,geometric | 'geometric' twice",
        "--policies zoom-out,zoom-in:x=1 | unknown option 'x=1', expected no options",
        "--policies zoom-out,zoom-out | 'zoom-out' twice",
        "--policies sarsa:gamma=2 | gamma is '2'",
        "--policies walk | unknown policy 'walk', expected one of ",
        "--detections geometric@0.5,geometric@.5 | 'geometric@0.5' twice",
        "--threshold 2 | threshold is 2.0, expected a number from 0 to 1",
        "--threads -1 | --threads is -1",
        "--repeat 0 | --repeat is 0",
        "--seed 9223372036854775779 | --seed is 9223372036854775779, expected at most",
      })
  void rejectsWrongUsageInOneLine(String options, String expected) {
    Path out = folder.resolve("out");
    Cli compare =
        Cli.run(
            Stream.concat(
                    Stream.of("compare", Cli.scenario("lattice-random"), "--out", out),
                    Arrays.stream(options.strip().split(" ")))
                .toArray());
    assertEquals(2, compare.exit(), compare.err());
    assertEquals(1, compare.err().lines().count(), compare.err());
    assertTrue(compare.err().contains(expected), compare.err());
    assertFalse(Files.exists(out));
  }

  @Test
  void rejectsFileAsOutputFolder() throws IOException {
    Path file = Files.writeString(folder.resolve("taken"), "mine");
    for (Path out : List.of(file, file.resolve("below"))) {
      Cli compare = Cli.run(words(out, 1, 1));
      assertEquals(2, compare.exit(), compare.err());
      assertTrue(compare.err().startsWith("error: folder '" + out + "' "), compare.err());
    }
    assertEquals("mine", Files.readString(file));
  }

  private static Object[] words(Path out, int steps, int repeats, Object... more) {
    return Stream.concat(
            Stream.of(
                "compare",
                Cli.scenario("lattice-random"),
                Cli.scenario("cluster-scripted"),
                "--detections",
                "camsim-range,hifi:orb-lin",
                "--policies",
                "zoom-out,epsilon-greedy:epsilon=0.2,fixed:1",
                "--seed",
                5,
                "--steps",
                steps,
                "--repeat",
                repeats,
                "--out",
                out),
            Arrays.stream(more))
        .toArray();
  }

  private static long journalled(Path out) throws IOException {
    Path journal = out.resolve(JOURNAL);
    if (!Files.exists(journal)) {
      return 0;
    }
    long lines = 0;
    for (byte b : Files.readAllBytes(journal)) {
      lines += b == '\n' ? 1 : 0;
    }
    return lines;
  }

  private static void assertSameFiles(Path expected, Path actual) throws IOException {
    List<String> names = Cli.names(expected);
    assertEquals(names, Cli.names(actual));
    assertTrue(names.contains("results.csv") && names.contains("steps.csv.gz"), names.toString());
    for (String name : names) {
      if (!List.of("manifest.json", "report.html", "ro-crate-metadata.json").contains(name)) {
        assertArrayEquals(
            Files.readAllBytes(expected.resolve(name)),
            Files.readAllBytes(actual.resolve(name)),
            name);
      }
    }
  }
}
