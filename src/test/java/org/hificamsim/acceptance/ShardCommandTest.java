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

/** A comparison in parts: the parts' runs make the files of the whole, and nothing less does. */
class ShardCommandTest {
  private static final int RUNS = (2 + 2) * 2; // with the optimum and the best fixed zoom

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
  void anyNumberOfPartsMergesToTheBytesOfTheWhole(int of) throws IOException {
    assertSameFiles(merge(parts(folder, of)));
  }

  @Test
  void partsMayComeInAnyOrder() throws IOException {
    assertSameFiles(merge(List.of(thirds.get(2), thirds.get(0), thirds.get(1))));
  }

  @Test
  void aPartMakesNoResultFiles() throws IOException {
    assertEquals(List.of("manifest.json", "runs.jsonl", "shard.json"), Cli.names(thirds.get(0)));
  }

  @Test
  void aPartThatWasCutOffIsCompletedByResume() throws IOException {
    List<Path> parts = parts(folder, 3);
    Path runs = parts.get(1).resolve("runs.jsonl");
    byte[] bytes = Files.readAllBytes(runs);
    Files.write(runs, Arrays.copyOf(bytes, bytes.length / 2));
    assertRefused("has 1 of the 3 runs of shard 2/3", merging(parts));
    List<String> before = Files.readAllLines(runs).subList(0, 1);
    assertEquals(0, Cli.run(words(parts.get(1), "--shard", "2/3", "--resume")).exit());
    assertEquals(before, Files.readAllLines(runs).subList(0, 1), "computed again");
    assertSameFiles(merge(parts));
  }

  @Test
  void aPartThatIsMissingIsNamed() {
    assertRefused(
        "--merge lacks 1 of 3 shards (2)", merging(List.of(thirds.get(0), thirds.get(2))));
  }

  @Test
  void aPartOfABillionIsRefusedWithoutAListOfTheOthers() throws IOException {
    Path first = parts(folder, 3).get(0);
    Path shard = first.resolve("shard.json");
    Files.writeString(shard, Files.readString(shard).replace("\"of\":3", "\"of\":1e9"));
    assertRefused(
        "--merge lacks 999999999 of 1000000000 shards (2, 3, 4, 5, 6, 7, 8, 9, 10, 11, ...)",
        merging(List.of(first)));
  }

  @Test
  void aPartThatComesTwiceIsNamed() {
    List<Path> twice = new ArrayList<>(thirds);
    twice.add(thirds.get(1));
    assertRefused("--merge has shard 2/3 twice", merging(twice));
  }

  @Test
  void aPartOfAnotherSplitIsNamed() {
    List<Path> mixed = List.of(thirds.get(0), parts(folder, 2).get(1));
    assertRefused("is shard 2/2 but", merging(mixed));
  }

  @Test
  void aPartOfAnotherComparisonIsNamed() {
    Object[] other =
        Stream.concat(Arrays.stream(merging(thirds)), Stream.of("--seed", 1)).toArray();
    assertRefused("is shard 1/3 of another comparison", other);
  }

  @Test
  void aFolderWithoutAPartIsNamed() throws IOException {
    assertRefused("has no shard.json", merging(List.of(whole)));
    Files.writeString(folder.resolve("shard.json"), "{\"comparison\": 3}");
    assertRefused("shard.json: expected what --shard writes", merging(List.of(folder)));
  }

  @Test
  void aFolderOfOnePartIsClosedToAnother() throws IOException {
    Path first = parts(folder, 3).get(0);
    byte[] runs = Files.readAllBytes(first.resolve("runs.jsonl"));
    assertRefused("holds shard 1/3, expected a folder of its own", words(first, "--shard", "2/3"));
    Object[] other = words(first, "--shard", "1/3", "--resume", "--order", "camsim");
    assertRefused("holds shard 1/3 of another comparison", other);
    assertArrayEquals(runs, Files.readAllBytes(first.resolve("runs.jsonl")));
  }

  @ParameterizedTest
  @ValueSource(strings = {"0/3", "4/3", "1", "1/0"})
  void wrongPartsAreRefused(String part) {
    Path out = folder.resolve("out");
    assertRefused("--shard is '" + part + "'", words(out, "--shard", part));
    assertFalse(Files.exists(out));
  }

  private static List<Path> parts(Path below, int of) {
    List<Path> parts = new ArrayList<>();
    for (int number = 1; number <= of; number++) {
      Path out = below.resolve(number + "-of-" + of);
      Cli part = Cli.run(words(out, "--shard", number + "/" + of));
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

  private static Object[] words(Path out, Object... more) {
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
            Arrays.stream(more))
        .toArray();
  }

  private static void assertRefused(String expected, Object... words) {
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
