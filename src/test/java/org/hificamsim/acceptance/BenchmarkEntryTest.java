package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.function.Consumer;
import java.util.function.UnaryOperator;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import org.hificamsim.core.file.Sha256;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.DynamicTest;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.TestFactory;
import org.junit.jupiter.api.io.TempDir;

/** Tests playing, checking and ranking entries of the benchmark. */
class BenchmarkEntryTest {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final String TASK = "passage-v1";

  @TempDir static Path folder;

  private static Path entry;

  @BeforeAll
  static void play() {
    entry = folder.resolve("entry");
    Cli cli =
        Cli.run(
            "benchmark",
            "run",
            "--policy",
            "cooperative",
            "--tasks",
            TASK + ",bench/street-v1",
            "--threads",
            2,
            "--out",
            entry);
    assertEquals(0, cli.exit(), cli.err());
    assertTrue(cli.out().contains(TASK), cli.out());
  }

  @Test
  void entryHasSameBytesOnAnyNumberOfThreads() throws IOException {
    Path again = folder.resolve("again");
    Cli.run(
        "benchmark",
        "run",
        "--policy",
        "cooperative",
        "--tasks",
        TASK + ",street-v1",
        "--threads",
        1,
        "--out",
        again);
    assertEquals(Cli.names(entry), Cli.names(again));
    for (String name : Cli.names(entry)) {
      assertEquals(-1, Files.mismatch(entry.resolve(name), again.resolve(name)), name);
    }
  }

  @Test
  void unchangedEntryIsAccepted() {
    Cli cli = Cli.run("benchmark", "check", entry, entry.resolve("entry.json"));
    assertEquals(0, cli.exit(), cli.err());
    assertTrue(cli.out().contains("cooperative, 2 tasks, agrees"), cli.out());
  }

  /** A change to a copy of an entry, and part of the expected error. */
  private record Broken(String reason, Consumer<Path> change) {}

  @TestFactory
  Stream<DynamicTest> rejectsBrokenEntries() {
    Map<String, Broken> changes =
        Map.ofEntries(
            Map.entry(
                "action outside", new Broken("has view 999, expected 0 to", csv(row(7, "999")))),
            Map.entry("action below", new Broken("has view -1, expected 0 to", csv(row(7, "-1")))),
            Map.entry(
                "half an action", new Broken("expected the number of a view", csv(row(7, "1.5")))),
            Map.entry(
                "another action",
                new Broken(
                    "seed 1000001: score",
                    csv(text -> text.replaceAll("(\n1000001,\\d+),\\d+", "$1,0")))),
            Map.entry(
                "a step gone",
                new Broken(
                    "no step 5 of seed", csv(text -> text.replaceFirst("\n1000001,5,[^\n]*", "")))),
            Map.entry(
                "a step more", new Broken("more rows", csv(text -> text + "1000010,100,0,0,0\n"))),
            Map.entry(
                "seed in rows",
                new Broken(
                    "of seed 1000001, expected every one",
                    csv(text -> text.replace("\n1000001,", "\n5,")))),
            Map.entry(
                "other cameras",
                new Broken("columns", csv(text -> text.replace("west", "nowhere")))),
            Map.entry(
                "actions without their hash",
                new Broken("SHA-256", path -> rewrite(path, row(7, "0")))),
            Map.entry(
                "no actions",
                new Broken("no such file", path -> delete(path.resolve(TASK + ".csv.gz")))),
            Map.entry(
                "another seed",
                new Broken("seeds", json(root -> ((ArrayNode) task(root).get("seeds")).set(0, 5)))),
            Map.entry(
                "score edited",
                new Broken(
                    "score 0.99",
                    json(root -> ((ArrayNode) task(root).get("scores")).set(0, 0.99)))),
            Map.entry(
                "too few scores",
                new Broken(
                    "number of scores",
                    json(root -> ((ArrayNode) task(root).get("scores")).remove(0)))),
            Map.entry(
                "another version",
                new Broken("version 9.9", json(root -> root.put("version", "9.9")))),
            Map.entry(
                "another task",
                new Broken("task has hash", json(root -> task(root).put("task", "0")))),
            Map.entry(
                "no such task",
                new Broken(
                    "expected one of",
                    json(root -> ((ObjectNode) root.get("tasks")).set("moon-v1", task(root))))),
            Map.entry(
                "a task under its other name too",
                new Broken(
                    "task 'bench/" + TASK + "', expected one of",
                    json(
                        root ->
                            ((ObjectNode) root.get("tasks")).set("bench/" + TASK, task(root))))),
            Map.entry(
                "a name that forges a line",
                new Broken(
                    "name has an invisible character",
                    json(root -> root.put("name", "x\nout/mine: mine, 12 tasks, agrees")))),
            Map.entry(
                "no visible name",
                new Broken("name has 1 characters", json(root -> root.put("name", " ")))),
            Map.entry(
                "a name in letters that look like others",
                new Broken(
                    "Latin letters and those of CYRILLIC",
                    json(root -> root.put("name", "c\u043e\u043eperative")))),
            Map.entry("no score", new Broken("something is missing", json(score(null)))),
            Map.entry(
                "a score that is no number",
                new Broken("score NaN, expected", json(score(Double.NaN)))),
            Map.entry("a negative score", new Broken("score -1.0, expected", json(score(-1.0)))),
            Map.entry("a huge score", new Broken("score 1.0E300, expected", json(score(1e300)))),
            Map.entry(
                "fewer steps",
                new Broken(
                    "no step 90 of seed 1000010",
                    csv(text -> text.replaceAll("\n1000010,9\\d,[^\n]*", "")))),
            Map.entry(
                "a link in place of actions",
                new Broken("is a link or no file", path -> link(path.resolve(TASK + ".csv.gz")))),
            Map.entry(
                "a link in place of an entry",
                new Broken("is a link or no file", path -> link(path.resolve("entry.json")))),
            Map.entry(
                "an endless entry",
                new Broken("has more than", json(root -> root.put("name", "x".repeat(2_000_000))))),
            Map.entry(
                "two results of a task",
                new Broken("Duplicate field 'tasks'", BenchmarkEntryTest::repeatTasks)),
            Map.entry("no task", new Broken("no task", json(root -> root.putObject("tasks")))),
            Map.entry(
                "a part missing",
                new Broken("something is missing", json(root -> task(root).remove("seeds")))),
            Map.entry(
                "something else",
                new Broken("unknown property more", json(root -> root.put("more", 1)))),
            Map.entry(
                "no JSON",
                new Broken(
                    "benchmark run",
                    path ->
                        write(path.resolve("entry.json"), "{".getBytes(StandardCharsets.UTF_8)))));
    return changes.entrySet().stream()
        .map(change -> DynamicTest.dynamicTest(change.getKey(), () -> refuses(change.getValue())));
  }

  private static void refuses(Broken broken) throws IOException {
    Path copy = Files.createTempDirectory(folder, "broken");
    for (String name : Cli.names(entry)) {
      Files.copy(entry.resolve(name), copy.resolve(name));
    }
    broken.change.accept(copy);
    Cli cli = Cli.run("benchmark", "check", copy);
    assertEquals(2, cli.exit(), cli.out());
    assertEquals(1, cli.err().lines().count(), cli.err());
    assertTrue(cli.err().contains(broken.reason), cli.err());
    assertEquals(
        2, Cli.run("benchmark", "leaderboard", copy, "--out", folder.resolve("no")).exit());
  }

  private static void repeatTasks(Path path) {
    try {
      String text = Files.readString(path.resolve("entry.json")).strip();
      ObjectNode root = (ObjectNode) MAPPER.readTree(text);
      String repeated = text.substring(0, text.length() - 1) + ",\"tasks\":" + root.get("tasks");
      write(path.resolve("entry.json"), (repeated + "}").getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  /** Returns a change of the table together with its hash. */
  private static Consumer<Path> csv(UnaryOperator<String> change) {
    return path -> {
      rewrite(path, change);
      json(root -> task(root).put("actions", hash(path.resolve(TASK + ".csv.gz")))).accept(path);
    };
  }

  private static Consumer<Path> json(Consumer<ObjectNode> change) {
    return path -> {
      try {
        ObjectNode root = (ObjectNode) MAPPER.readTree(path.resolve("entry.json").toFile());
        change.accept(root);
        MAPPER.writeValue(path.resolve("entry.json").toFile(), root);
      } catch (IOException e) {
        throw new AssertionError(e);
      }
    };
  }

  private static Consumer<ObjectNode> score(Double score) {
    return root -> {
      ArrayNode scores = (ArrayNode) task(root).get("scores");
      if (score != null && score.isNaN()) {
        scores.set(0, "NaN");
      } else {
        scores.set(0, score);
      }
    };
  }

  /** Moves a file elsewhere, with a link to it in its place. */
  private static void link(Path file) {
    try {
      Path target = Files.createTempDirectory(folder, "elsewhere").resolve("file");
      Files.move(file, target);
      Files.createSymbolicLink(file, target);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private static ObjectNode task(ObjectNode root) {
    return (ObjectNode) root.get("tasks").get(TASK);
  }

  /** Returns a change of the first camera's view at a step of the first episode. */
  private static UnaryOperator<String> row(int step, String view) {
    return text ->
        text.replaceFirst("\n1000001," + step + ",\\d+", "\n1000001," + step + "," + view);
  }

  private static void rewrite(Path path, UnaryOperator<String> change) {
    Path file = path.resolve(TASK + ".csv.gz");
    try (InputStream in = new GZIPInputStream(Files.newInputStream(file))) {
      String text = change.apply(new String(in.readAllBytes(), StandardCharsets.UTF_8));
      try (OutputStream out = new GZIPOutputStream(Files.newOutputStream(file))) {
        out.write(text.getBytes(StandardCharsets.UTF_8));
      }
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private static String hash(Path file) {
    try {
      return Sha256.of(file);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private static void delete(Path file) {
    try {
      Files.delete(file);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private static void write(Path file, byte[] content) {
    try {
      Files.write(file, content);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  @Test
  void entryOfArenaOfMateCanBePlayed() {
    Cli cli = Cli.run("benchmark", "arena", "--episodes", 2, "--seed", 5);
    assertEquals(0, cli.exit(), cli.err());
    assertTrue(cli.out().matches("coverage  0\\.[\\s\\S]*transport 0\\.[\\s\\S]*steps [\\s\\S]*"));
    assertEquals(cli.out(), Cli.run("benchmark", "arena", "--episodes", 2, "--seed", 5).out());
    Cli none = Cli.run("benchmark", "arena", "--episodes", 0);
    assertEquals(2, none.exit());
    assertTrue(none.err().contains("--episodes is 0, expected a whole number from 1"), none.err());
  }

  @Test
  void rejectsInvalidOptions() {
    for (List<String> words :
        List.of(
            List.of("--policy", "cooperative", "--tasks", "moon-v1"),
            List.of("--policy", "cooperative", "--tasks", TASK + "," + TASK),
            List.of("--policy", "no-such-policy"),
            List.of("--policy", "onnx:file={task}-{seed}.onnx"),
            List.of("--policy", "cooperative", "--name", "mine\nout/other: other, agrees"),
            List.of("--policy", "optimal"),
            List.of("--policy", "best-fixed"))) {
      Cli cli =
          Cli.run(
              Stream.concat(
                      Stream.of("benchmark", "run", "--out", folder.resolve("wrong")),
                      words.stream())
                  .toArray());
      assertEquals(2, cli.exit(), cli.out());
      assertEquals(1, cli.err().lines().count(), cli.err());
    }
  }

  @Test
  void boardRanksDeployablePoliciesThatPlayedAllTasks() throws IOException {
    Path tracker = folder.resolve("tracker");
    Cli.run("benchmark", "run", "--policy", "tracker", "--name", "<tracker>", "--out", tracker);
    Path greedy = folder.resolve("greedy");
    Cli played = Cli.run("benchmark", "run", "--policy", "independent-greedy", "--out", greedy);
    assertTrue(played.out().contains("plays out of competition"), played.out());
    Path page = folder.resolve("page");
    Cli cli = Cli.run("benchmark", "leaderboard", entry, greedy, tracker, "--out", page);
    assertEquals(0, cli.exit(), cli.err());
    List<String> lines = cli.out().lines().toList();
    assertTrue(
        lines.get(0).matches("0\\.\\d+ \\[0\\.\\d+, 0\\.\\d+\\]  actions      <tracker>"),
        cli.out());
    String bound = "-  independent-greedy (a bound, out of competition): 0.6";
    assertTrue(lines.get(1).startsWith(bound), cli.out());
    String partly = "-  cooperative, no place without all tasks: passage-v1 0.";
    assertTrue(lines.get(2).startsWith(partly), cli.out());
    String html = Files.readString(page.resolve("leaderboard.html"));
    assertTrue(html.contains("\\u003ctracker>") && !html.contains("<tracker>"));
    assertTrue(html.contains("independent-greedy (a bound, out of competition)"));
    assertTrue(Files.readString(page.resolve("leaderboard.csv")).contains("iqm"));
  }
}
