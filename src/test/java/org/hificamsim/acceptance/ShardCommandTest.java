package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests that the merged shards of a comparison have the same files as the whole comparison. */
class ShardCommandTest {
  private static final int RUNS = (2 + 2) * 2; // two policies and two yardsticks, two seeds

  @TempDir static Path shared;
  private static Path whole;
  private static List<Path> thirds;

  @TempDir Path folder;

  @BeforeAll
  static void computeTheWholeAndThreeParts() {
    whole = shared.resolve("whole");
    assertEquals(0, Cli.run(words(whole)).exit());
    thirds = parts(shared, 3);
  }

  @ParameterizedTest
  @ValueSource(ints = {1, 2, RUNS + 3})
  void mergedShardsEqualWholeComparison(int count) throws IOException {
    assertSameFiles(merge(parts(folder, count)));
  }

  @Test
  void shardsMayBeInAnyOrder() throws IOException {
    assertSameFiles(merge(List.of(thirds.get(2), thirds.get(0), thirds.get(1))));
  }

  @Test
  void shardWritesNoResultFiles() throws IOException {
    assertEquals(List.of("manifest.json", "runs.jsonl"), Cli.names(thirds.get(0)));
  }

  @Test
  void resumeCompletesInterruptedShard() throws IOException {
    List<Path> parts = parts(folder, 3);
    Path runs = parts.get(1).resolve("runs.jsonl");
    byte[] bytes = Files.readAllBytes(runs);
    Files.write(runs, Arrays.copyOf(bytes, bytes.length / 2));
    assertRejected("--merge lacks 2 of 8 runs, such as scenario lattice-random", merging(parts));
    List<String> before = Files.readAllLines(runs).subList(0, 1);
    assertEquals(0, Cli.run(words(parts.get(1), "--shard", "2/3", "--resume")).exit());
    assertEquals(before, Files.readAllLines(runs).subList(0, 1), "computed again");
    assertSameFiles(merge(parts));
  }

  @Test
  void rejectsMissingShard() {
    assertRejected("--merge lacks 3 of 8 runs", merging(List.of(thirds.get(0), thirds.get(2))));
  }

  @Test
  void countsRunsOfOverlappingShardsOnce() throws IOException {
    List<Path> further = new ArrayList<>(thirds);
    further.add(thirds.get(1));
    further.addAll(parts(folder, 2));
    assertSameFiles(merge(further));
  }

  @Test
  void ignoresShardsOfAnotherComparison() {
    Object[] other =
        Stream.concat(Arrays.stream(merging(thirds)), Stream.of("--seed", 100)).toArray();
    assertRejected("--merge lacks 8 of 8 runs", other);
  }

  @Test
  void rejectsFolderWithoutShard() {
    assertRejected("runs.jsonl', expected what --shard writes", merging(List.of(whole)));
  }

  @Test
  void keepsExistingRuns() throws IOException {
    Path first = parts(folder, 3).get(0);
    List<String> runs = Files.readAllLines(first.resolve("runs.jsonl"));
    assertRejected("expected another folder, or --resume", words(first, "--shard", "2/3"));
    assertEquals(0, Cli.run(words(first, "--shard", "2/3", "--resume")).exit());
    List<String> further = Files.readAllLines(first.resolve("runs.jsonl"));
    assertEquals(runs, further.subList(0, runs.size()));
    assertSameFiles(merge(List.of(first, thirds.get(2))));
  }

  @Test
  void keepsForeignFileOfSameName() throws IOException {
    Path out = Files.createDirectory(folder.resolve("own"));
    Path notes = Files.writeString(out.resolve("runs.jsonl"), "my notes");
    assertRejected("no shard wrote it", words(out, "--shard", "2/3", "--resume"));
    assertEquals("my notes", Files.readString(notes));
  }

  @ParameterizedTest
  @ValueSource(strings = {"0/3", "4/3", "1", "1/0"})
  void rejectsMalformedShards(String part) {
    Path out = folder.resolve("out");
    assertRejected("--shard is '" + part + "'", words(out, "--shard", part));
    assertFalse(Files.exists(out));
  }

  private static List<Path> parts(Path below, int count) {
    List<Path> parts = new ArrayList<>();
    for (int number = 1; number <= count; number++) {
      Path out = below.resolve(number + "-of-" + count);
      Cli part = Cli.run(words(out, "--shard", number + "/" + count));
      assertEquals(0, part.exit(), part.err());
      parts.add(out);
    }
    return parts;
  }

  private Path merge(List<Path> parts) {
    Cli merge = Cli.run(merging(parts));
    assertEquals(0, merge.exit(), merge.err());
    return folder.resolve("merged");
  }

  private Object[] merging(List<Path> parts) {
    return Stream.concat(Arrays.stream(words(folder.resolve("merged"), "--merge")), parts.stream())
        .toArray();
  }

  private static Object[] words(Path out, Object... further) {
    return Stream.concat(
            Stream.of(
                "compare",
                Cli.scenario("lattice-random"),
                "--detections",
                "hifi:orb-lin",
                "--policies",
                "zoom-out,epsilon-greedy",
                "--steps",
                30,
                "--repeat",
                2,
                "--out",
                out),
            Arrays.stream(further))
        .toArray();
  }

  private static void assertRejected(String expected, Object... words) {
    Cli cli = Cli.run(words);
    assertEquals(2, cli.exit(), cli.err());
    assertEquals(1, cli.err().lines().count(), cli.err());
    assertTrue(cli.err().contains(expected), cli.err());
  }

  private static void assertSameFiles(Path merged) throws IOException {
    assertEquals(Cli.names(whole), Cli.names(merged));
    assertTrue(Cli.names(whole).contains("results.csv"));
    for (String name : Cli.names(whole)) {
      if (!List.of("manifest.json", "report.html", "ro-crate-metadata.json").contains(name)) {
        assertArrayEquals(
            Files.readAllBytes(whole.resolve(name)),
            Files.readAllBytes(merged.resolve(name)),
            name);
      }
    }
  }
}
