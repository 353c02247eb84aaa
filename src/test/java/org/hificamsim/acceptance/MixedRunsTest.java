package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystem;
import java.nio.file.FileSystems;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.file.Sha256;
import org.hificamsim.runs.output.ManifestFile;
import org.junit.jupiter.api.BeforeEach;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests that runs of different inputs with the same name are never mixed. */
class MixedRunsTest {
  /** A model of which the tests use two versions, which differ at 30 m but not below 16 m. */
  private static final String MODEL =
      """
      {"schema": "hificamsim-model", "version": 1, "name": "mine",
       "f": {"type": "svr-rbf", "gamma": 10, "intercept": 1.5,
             "ranges": {"q": {"least": 0, "most": 1}, "d": {"least": 0, "most": 1},
                        "z": {"least": 0, "most": 1}},
             "support": [[0.5, 30, 0.02, WEIGHT]]},
       "g": {"slope": 0.571, "intercept": 0.026}, "threshold": 0.05}
      """;

  @TempDir Path folder;

  private Path model;
  private Path scenario;

  @BeforeEach
  void writeInputs() throws IOException {
    model = Files.writeString(folder.resolve("model.json"), MODEL.replace("WEIGHT", "-2"));
    scenario = Files.copy(Cli.scenario("lattice-random"), folder.resolve("field.xml"));
  }

  @Test
  void resumeWithSameInputsWritesSameBytes() throws IOException {
    Path out = interrupted();
    Path whole = folder.resolve("whole");
    assertEquals(0, Cli.run(words(model, whole)).exit());
    Cli resumed = Cli.run(words(model, out, "--resume"));
    assertEquals(0, resumed.exit(), resumed.err());
    for (String name : new String[] {"results.csv", "metrics.csv", "steps.csv.gz"}) {
      assertArrayEquals(
          Files.readAllBytes(whole.resolve(name)), Files.readAllBytes(out.resolve(name)), name);
    }
  }

  @Test
  void rejectsChangedModelAndKeepsRuns() throws IOException {
    Path out = interrupted();
    byte[] journal = Files.readAllBytes(out.resolve(".compare.journal"));
    Files.writeString(model, MODEL.replace("WEIGHT", "2"));
    refused("has runs of another detection 'mine'", words(model, out, "--resume"));
    assertArrayEquals(journal, Files.readAllBytes(out.resolve(".compare.journal")));
    assertFalse(Files.exists(out.resolve("results.csv")));
  }

  @Test
  void rejectsChangedScenario() throws IOException {
    Path out = interrupted();
    Files.copy(
        Cli.scenario("ring-random"), scenario, java.nio.file.StandardCopyOption.REPLACE_EXISTING);
    refused("has runs of another scenario 'field'", words(model, out, "--resume"));
  }

  @Test
  void rejectsRunsOfAnotherVersion() throws IOException {
    Path out = interrupted();
    Path journal = out.resolve(".compare.journal");
    String runs = Files.readString(journal);
    assertTrue(runs.contains(ManifestFile.version()), runs);
    Files.writeString(journal, summed(runs.replace(ManifestFile.version(), "0.0.1")));
    refused("has runs of another version of 'hificamsim'", words(model, out, "--resume"));
  }

  @Test
  void recomputesDamagedLinesWithWarning() throws IOException {
    Path out = interrupted();
    Path journal = out.resolve(".compare.journal");
    String runs = Files.readString(journal);
    Files.writeString(journal, runs.replace(ManifestFile.version(), "0.0.1"));
    Cli resumed = Cli.run(words(model, out, "--resume"));
    assertEquals(0, resumed.exit(), resumed.err());
    assertTrue(resumed.err().contains("damaged"), resumed.err());
  }

  @Test
  void acceptsRunsWithOtherSettings() throws IOException {
    Cli other = Cli.run(words(model, interrupted(), "--resume", "--threshold", 0.2));
    assertEquals(0, other.exit(), other.err());
  }

  @Test
  void rejectsMergeOfDifferentModels() throws IOException {
    Path first = folder.resolve("one");
    Path second = folder.resolve("two");
    assertEquals(0, Cli.run(words(model, first, "--shard", "1/2")).exit());
    Files.writeString(model, MODEL.replace("WEIGHT", "2"));
    assertEquals(0, Cli.run(words(model, second, "--shard", "2/2")).exit());
    refused(
        "'%s' has runs of another detection 'mine'".formatted(first.resolve("runs.jsonl")),
        words(model, folder.resolve("merged"), "--merge", first, second));
    refused(
        "has runs of another detection 'mine'", words(model, first, "--shard", "1/2", "--resume"));
  }

  @Test
  void rejectsChangedJarOfModel() throws Exception {
    Example fog = Example.pack("own-detection", folder);
    Path part = folder.resolve("part");
    assertEquals(0, fog.run(words("fog", part, "--shard", "1/1")).exit());
    Path out = asInterrupted(part);
    try (FileSystem jar = FileSystems.newFileSystem(fog.jar())) {
      Files.writeString(jar.getPath("/org/example/density.txt"), "0.3");
    }
    Cli resumed = fog.run(words("fog", out, "--resume"));
    assertEquals(2, resumed.exit(), resumed.out());
    assertTrue(
        resumed.out().contains("another jar of class 'org.example.FogDetection'"), resumed.out());
  }

  /** Returns the folder of a comparison that was killed when all its runs were in the journal. */
  private Path interrupted() throws IOException {
    Path part = folder.resolve("part");
    assertEquals(0, Cli.run(words(model, part, "--shard", "1/1")).exit());
    return asInterrupted(part);
  }

  private Path asInterrupted(Path part) throws IOException {
    Path out = Files.createDirectories(folder.resolve("out"));
    Files.copy(part.resolve("runs.jsonl"), out.resolve(".compare.journal"));
    return out;
  }

  private Object[] words(Object detection, Path out, Object... more) {
    Object[] words = {
      "compare",
      scenario,
      "--detections",
      detection,
      "--policies",
      "zoom-out",
      "--steps",
      20,
      "--repeat",
      2,
      "--out",
      out
    };
    return Stream.concat(Arrays.stream(words), Arrays.stream(more)).toArray();
  }

  /** Returns changed lines with checksums that are right again. */
  private static String summed(String journal) {
    return journal
        .lines()
        .map(line -> line.substring(line.indexOf("\",") + 2))
        .map(rest -> "{\"sum\":\"" + sum(rest) + "\"," + rest + "\n")
        .collect(Collectors.joining());
  }

  private static String sum(String rest) {
    return Sha256.of(rest.getBytes(StandardCharsets.UTF_8)).substring(0, 16);
  }

  private static void refused(String expected, Object... words) {
    Cli cli = Cli.run(words);
    assertEquals(2, cli.exit(), cli.err());
    assertEquals(
        1, cli.err().lines().filter(line -> !line.startsWith("warning: ")).count(), cli.err());
    assertTrue(cli.err().contains(expected), cli.err());
  }
}
