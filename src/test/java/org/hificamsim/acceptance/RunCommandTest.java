package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests what {@code run} writes, prints and rejects. */
class RunCommandTest {
  private static final Path LATTICE = Cli.scenario("lattice-random");

  @TempDir Path folder;

  @Test
  void writesStepsAndSummary() throws IOException {
    Path out = folder.resolve("out");
    Cli run = Cli.run("run", LATTICE, "--steps", 50, "--repeat", 2, "--out", out);
    assertEquals(0, run.exit(), run.err());
    List<String> rows = Files.readAllLines(out.resolve("steps.csv"));
    assertEquals("run,step,k_min,targets,covered_0,covered_1,covered_k,mean_k,score", rows.get(0));
    assertEquals(101, rows.size());
    JsonNode summary = summary(out);
    for (int repeat = 0; repeat < 2; repeat++) {
      String prefix = repeat + ",";
      long sum =
          rows.stream()
              .skip(1)
              .filter(row -> row.startsWith(prefix))
              .mapToLong(row -> Long.parseLong(row.split(",")[2]))
              .sum();
      assertEquals(sum, summary.get("runs").get(repeat).get("performance").asLong());
    }
    JsonNode interval = summary.get("interval_95").get("performance");
    double mean = summary.get("performance").asDouble();
    assertTrue(interval.get(0).asDouble() <= mean && mean <= interval.get(1).asDouble());
    assertEquals(
        1.0,
        Stream.of("covered_0", "covered_1", "covered_k")
            .mapToDouble(name -> summary.get(name).asDouble())
            .sum(),
        1e-12);
  }

  @Test
  void usesDocumentedDefaults() throws IOException {
    Path out = folder.resolve("out");
    Cli.run("run", LATTICE, "--out", out);
    JsonNode summary = summary(out);
    assertEquals("hifi:orb-lin", summary.get("detection").asText());
    assertEquals("epsilon-greedy", summary.get("policy").asText());
    assertEquals(1000, summary.get("steps").asInt());
    assertEquals(0, summary.get("seed").asInt());
    assertEquals(0.0441, summary.get("threshold").asDouble());
    assertEquals("coverage", summary.get("order").asText());
    assertEquals(1001, Files.readAllLines(out.resolve("steps.csv")).size());
  }

  @Test
  void recordsOnRequestAndRemovesStaleRecords() throws IOException {
    Cli.run("run", LATTICE, "--steps", 10, "--record", "--out", folder);
    List<String> zooms = Files.readAllLines(folder.resolve("zooms.csv"));
    assertEquals("run,step,camera,level,radius,detected", zooms.get(0));
    assertEquals(1 + 9 * 10, zooms.size());
    List<String> targets = Files.readAllLines(folder.resolve("targets.csv"));
    assertEquals("run,step,target,x,y", targets.get(0));
    assertEquals(1 + 3 * 10, targets.size());
    Cli.run("run", LATTICE, "--steps", 10, "--out", folder);
    assertFalse(Files.exists(folder.resolve("zooms.csv")));
    assertFalse(Files.exists(folder.resolve("targets.csv")));
  }

  @Test
  void writesOnlyItsFiles() throws IOException {
    Cli.run("run", LATTICE, "--steps", 10, "--out", folder);
    try (Stream<Path> files = Files.list(folder)) {
      assertEquals(
          List.of(
              "detection-hifi-orb-lin.json",
              "manifest.json",
              "ro-crate-metadata.json",
              "scenario-lattice-random.xml",
              "steps.csv",
              "summary.json"),
          files
              .map(file -> file.getFileName().toString())
              .filter(name -> !name.equals(".hificamsim.sha256"))
              .sorted()
              .toList());
    }
    String manifest = Files.readString(folder.resolve("manifest.json"));
    assertFalse(manifest.contains("development"), manifest);
  }

  @Test
  void printsMeanKMinOverTime() throws IOException {
    Cli run = Cli.run("run", LATTICE, "--steps", 100, "--repeat", 3, "--out", folder);
    double[] means = new double[40];
    int[] counts = new int[40];
    for (String row : Files.readAllLines(folder.resolve("steps.csv")).subList(1, 301)) {
      String[] fields = row.split(",");
      int part = Integer.parseInt(fields[1]) * 40 / 100;
      means[part] += Integer.parseInt(fields[2]);
      counts[part]++;
    }
    Arrays.setAll(means, part -> means[part] / counts[part]);
    double most = Arrays.stream(means).max().orElseThrow();
    String line =
        run.out().lines().filter(l -> l.startsWith("k_min over time")).findFirst().orElseThrow();
    String bars = line.replaceFirst("k_min over time +(\\S+)  .*", "$1");
    assertTrue(line.endsWith(String.format(Locale.ROOT, " %.2f)", most)), line);
    assertEquals(40, bars.length());
    char full = line.charAt(line.indexOf(" to ") + 4);
    char empty = line.charAt(line.indexOf('(') + 1);
    for (int part = 0; part < 40; part++) {
      assertEquals(means[part] > most * 13 / 14, bars.charAt(part) == full, line);
      assertEquals(means[part] < most / 14, bars.charAt(part) == empty, line);
    }
  }

  @Test
  void quietPrintsOnlyErrors() throws IOException {
    Path odd =
        Files.writeString(
            folder.resolve("odd.xml"),
            Files.readString(LATTICE).replaceFirst("<camera ", "<camera hue=\"1\" "));
    Cli run = Cli.run("run", odd, "--steps", 5, "--quiet", "--out", folder.resolve("out"));
    assertEquals(new Cli(0, "", ""), run);
    assertTrue(Files.exists(folder.resolve("out/steps.csv")));
    Cli wrong = Cli.run("run", odd, "--quiet", "--policy", "none", "--out", folder);
    assertEquals(2, wrong.exit());
    assertTrue(wrong.err().startsWith("error: unknown policy 'none'"), wrong.err());
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--steps 0 | --steps is 0, expected a whole number from 1",
        "--steps abc | 'abc'",
        "--repeat 0 | --repeat is 0",
        "--seed x | 'x'",
        "--seed 9223372036854775807 --repeat 2 | --seed is 9223372036854775807, expected at most",
        "--threshold 1.5 | --threshold is 1.5, expected a number from 0 to 1",
        "--threshold NaN | --threshold is NaN",
        "--detection hifi:orb-cubic | unknown detection 'hifi:orb-cubic', expected one of"
            + " hifi:orb-",
        "--detection nothing.json | nothing.json",
        "--detection geometric@2 | threshold is 2.0, expected a number from 0 to 1",
        "--policy epsilon | unknown policy 'epsilon', expected one of ",
        "--policy epsilon-greedy:epsilon=2 | epsilon is '2', expected a number from 0.0 to 1.0",
        "--policy epsilon-greedy:gamma=2 | unknown option 'gamma=2', expected one of epsilon",
        "--policy fixed:9 | 9",
        "--policy sarsa:alpha | policy sarsa: option 'alpha' has no value, expected alpha=VALUE",
        "--order sideways | --order is 'sideways', expected one of coverage, camsim",
        "--headings grads | --headings is 'grads', expected one of degrees, as-radians",
        "--format arrow | --format is 'arrow', expected one of csv, parquet",
        "--format parquet | 'parquet' is not on the class path, expected its jars in CLASSPATH",
        "--listener nobody | unknown listener 'nobody', expected one of UserListener",
        "--colour blue | '--colour'",
      })
  void rejectsWrongUsageInOneLine(String options, String expected) {
    Path out = folder.resolve("out");
    Object[] words =
        Stream.concat(
                Stream.of("run", LATTICE, "--out", out), Stream.of(options.strip().split(" ")))
            .toArray();
    Cli run = Cli.run(words);
    assertEquals(2, run.exit(), run.err());
    assertEquals(1, run.err().lines().count(), run.err());
    assertTrue(run.err().startsWith("error: "), run.err());
    assertTrue(run.err().contains(expected), run.err());
    assertEquals("", run.out());
    assertFalse(Files.exists(out));
  }

  @Test
  void printsErrorInOneLineForAnyArgument() {
    for (String word : List.of("two\nlines", "es\u001b[31mcape")) {
      for (Cli run :
          List.of(
              Cli.run("run", LATTICE, "--policy", word, "--out", folder.resolve("out")),
              Cli.run("run", LATTICE, "--detection", word, "--out", folder.resolve("out")),
              Cli.run("run", folder.resolve(word)),
              Cli.run("validate", folder.resolve(word)))) {
        assertEquals(2, run.exit(), run.err());
        assertEquals(1, run.err().lines().count(), run.err());
        assertFalse(run.err().contains("\u001b"), run.err());
      }
    }
  }

  @Test
  void warnsInOneLineForAnyAttribute() throws IOException {
    Path scenario = folder.resolve("own.xml");
    Files.writeString(
        scenario,
        Files.readString(LATTICE).replaceFirst("<camera ", "<camera hue=\"&#x9b;31m&#10;\" "));
    Cli run = Cli.run("run", scenario, "--steps", 1, "--out", folder);
    assertEquals(0, run.exit(), run.err());
    String message =
        run.err().lines().filter(line -> line.contains("hue=")).findFirst().orElseThrow();
    assertTrue(message.startsWith("warning: " + scenario + ":"), message);
    assertFalse(message.contains("\u009b"), message);
  }

  @Test
  void rejectsFileAsOutputFolder() throws IOException {
    Path file = Files.writeString(folder.resolve("taken"), "mine");
    Cli run = Cli.run("run", LATTICE, "--steps", 1, "--out", file);
    assertEquals(2, run.exit());
    assertEquals("mine", Files.readString(file));
  }

  @ParameterizedTest
  @ValueSource(strings = {"hifi:surf-power", "hifi:sift-sr", "geometric", "camsim-standard"})
  void runsUnderEveryKindOfDetection(String detection) throws IOException {
    Cli run = Cli.run("run", LATTICE, "--steps", 5, "--detection", detection, "--out", folder);
    assertEquals(0, run.exit(), run.err());
    assertEquals(detection, summary(folder).get("detection").asText());
  }

  @Test
  void thresholdInDetectionOverridesOptionAndScenario() throws IOException {
    Path scenario = folder.resolve("own.xml");
    Files.writeString(
        scenario,
        Files.readString(LATTICE)
            .replace("order=\"coverage\"", "order=\"coverage\" threshold=\"0.2\""));
    Cli.run("run", scenario, "--steps", 1, "--out", folder.resolve("a"));
    assertEquals(0.2, summary(folder.resolve("a")).get("threshold").asDouble());
    Cli.run("run", scenario, "--steps", 1, "--threshold", "0.1", "--out", folder.resolve("b"));
    assertEquals(0.1, summary(folder.resolve("b")).get("threshold").asDouble());
    String own = "geometric@0.3";
    Object[] words = {"run", scenario, "--detection", own, "--threshold", 0.1, "--steps", 1};
    Cli.run(Stream.concat(Arrays.stream(words), Stream.of("--out", folder.resolve("c"))).toArray());
    assertEquals(0.3, summary(folder.resolve("c")).get("threshold").asDouble());
    assertEquals(own, summary(folder.resolve("c")).get("detection").asText());
  }

  private static JsonNode summary(Path out) throws IOException {
    return new ObjectMapper().readTree(out.resolve("summary.json").toFile());
  }
}
