package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ArrayNode;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.ByteArrayInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.Consumer;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import java.util.zip.GZIPInputStream;
import java.util.zip.GZIPOutputStream;
import org.hificamsim.core.file.Sha256;
import org.hificamsim.core.program.Sandbox;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests {@code benchmark verify} with honest entries and with entries that cheat. */
class VerifyEntryTest {
  private static final ObjectMapper MAPPER = new ObjectMapper();
  private static final String TASK = "passage-v1";
  private static final String ACTIONS = TASK + ".csv.gz";

  @TempDir static Path folder;

  private static Path honest;
  private static Path better;

  @BeforeAll
  static void play() {
    honest = play("tracker");
    better = play("independent-greedy");
  }

  private static Path play(String policy) {
    Path out = folder.resolve(policy);
    Cli cli = Cli.run("benchmark", "run", "--policy", policy, "--tasks", TASK, "--out", out);
    assertEquals(0, cli.exit(), cli.err());
    return out;
  }

  private static Cli verify(Path entry, Path out) {
    return Cli.run("benchmark", "verify", entry, "--secret", "not to be guessed", "--out", out);
  }

  @Test
  void verifiesHonestEntryAndMarksItOnTheBoard() throws IOException {
    Path out = folder.resolve("verified");
    Cli cli = verify(honest, out);
    assertEquals(0, cli.exit(), cli.out() + cli.err());
    assertTrue(cli.out().lines().anyMatch("verified"::equals), cli.out());
    Path again = folder.resolve("verified-again");
    verify(honest, again);
    assertEquals(-1, Files.mismatch(out.resolve("verified.json"), again.resolve("verified.json")));
    Path board = folder.resolve("board");
    Cli ranked =
        Cli.run("benchmark", "leaderboard", honest, better, "--verified", out, "--out", board);
    assertEquals(0, ranked.exit(), ranked.err());
    List<String> rows = Files.readAllLines(board.resolve("leaderboard.csv"));
    String how = Sandbox.confines() ? "fresh seeds" : "unconfined";
    assertTrue(rows.stream().anyMatch(row -> row.startsWith("tracker,tracker," + how + ",")));
    assertTrue(rows.stream().anyMatch(row -> row.contains("independent-greedy,actions,")));
  }

  @Test
  void ranksNoUnverifiedEntryAmongVerifiedOnes() throws IOException {
    Path out = folder.resolve("verified-for-rank");
    verify(honest, out);
    Path board = folder.resolve("board-of-verified");
    Path other = play("random");
    Cli.run("benchmark", "leaderboard", honest, other, "--verified", out, "--out", board);
    String page = Files.readString(board.resolve("leaderboard.html"));
    assertTrue(page.contains("random (not verified, no rank)"), page);
    assertFalse(page.contains("tracker (not verified"), page);
    Cli.run("benchmark", "leaderboard", honest, other, "--out", folder.resolve("board-of-all"));
    String all = Files.readString(folder.resolve("board-of-all").resolve("leaderboard.html"));
    assertFalse(all.contains("not verified"), all);
  }

  @Test
  void readsSecretFromInputIfOptionHasNone() throws IOException {
    Path told = folder.resolve("told");
    Path asked = folder.resolve("asked");
    verify(honest, told);
    InputStream input = System.in;
    try {
      System.setIn(
          new ByteArrayInputStream("not to be guessed\n".getBytes(StandardCharsets.UTF_8)));
      assertEquals(0, Cli.run("benchmark", "verify", honest, "--out", asked, "--secret").exit());
    } finally {
      System.setIn(input);
    }
    assertEquals(-1, Files.mismatch(told.resolve("verified.json"), asked.resolve("verified.json")));
  }

  @Test
  void boardMarksEntryWhosePolicyCouldReadFiles() throws IOException {
    Path out = folder.resolve("unconfined");
    verify(honest, out);
    Path found = out.resolve("verified.json");
    ObjectNode root = (ObjectNode) MAPPER.readTree(found.toFile());
    MAPPER.writeValue(found.toFile(), root.put("confined", false));
    Path board = folder.resolve("board-unconfined");
    Cli.run("benchmark", "leaderboard", honest, "--verified", out, "--out", board);
    String rows = Files.readString(board.resolve("leaderboard.csv"));
    assertTrue(rows.contains("\ntracker,tracker,unconfined,"), rows);
  }

  @Test
  void reportsPlaceOfScoreThatIsNotANumber() throws IOException {
    Path entry = copy(honest, root -> ((ArrayNode) task(root).get("scores")).set(0, "much"));
    Cli cli = Cli.run("benchmark", "check", entry);
    assertEquals(2, cli.exit());
    assertTrue(
        cli.err()
            .matches("(?s).*entry.json:1:\\d+: tasks.passage-v1.scores\\[0] is not a number.*"),
        cli.err());
  }

  @Test
  void marksActionsOfBoundsUnderTheNameOfAPolicy() throws IOException {
    Path cheat = copy(better, root -> root.put("policy", "tracker"));
    assertEquals(0, Cli.run("benchmark", "check", cheat).exit());
    Path out = folder.resolve("bound-verified");
    Cli cli = verify(cheat, out);
    assertEquals(1, cli.exit(), cli.out());
    assertTrue(cli.out().contains("the policy scores otherwise in testing"), cli.out());
    assertTrue(cli.out().lines().anyMatch("NOT verified"::equals), cli.out());
    Path board = folder.resolve("board-of-cheats");
    Cli.run("benchmark", "leaderboard", cheat, "--verified", out, "--out", board);
    assertTrue(Files.readString(board.resolve("leaderboard.csv")).contains(",not held,"));
    assertTrue(Files.readString(board.resolve("leaderboard.html")).contains("no rank"));
  }

  /** The entry has one episode of another policy, with its actions and its score. */
  @Test
  void marksSplicedEpisodes() throws IOException {
    double score = score(better, 0);
    Path cheat = copy(honest, root -> ((ArrayNode) task(root).get("scores")).set(0, score));
    String spliced =
        Stream.concat(
                rows(better).filter(row -> row.startsWith("1000001,")),
                rows(honest).skip(1).filter(row -> !row.startsWith("1000001,")))
            .collect(Collectors.joining("\n", rows(honest).findFirst().orElseThrow() + "\n", "\n"));
    enterRows(cheat, spliced);
    Cli checked = Cli.run("benchmark", "check", cheat);
    assertEquals(0, checked.exit(), checked.err());
    Cli cli = verify(cheat, folder.resolve("spliced-verified"));
    assertEquals(1, cli.exit(), cli.out());
    assertTrue(cli.out().contains("the policy scores otherwise in testing"), cli.out());
  }

  @Test
  void rejectsEntriesWithoutOnePolicyForAllSeeds() throws IOException {
    assertRejected(copy(honest, root -> root.put("policy", "played")), "a list of actions");
    Path seeded = copy(honest, root -> root.put("policy", "onnx:file={seed}.onnx"));
    assertRejected(seeded, "has {seed}");
    assertEquals(2, Cli.run("benchmark", "check", seeded).exit(), "a board would believe it");
    assertRejected(better, "independent-greedy is a bound");
    assertRejected(copy(better, root -> root.put("policy", "greedy")), "greedy is a bound");
    assertRejected(copy(honest, root -> root.put("policy", "optimal")), "optimal is a bound");
    Path files = copy(honest, root -> root.putObject("files").put("a.onnx", "0"));
    assertRejected(files, "policy-a.onnx: no such file");
    Files.writeString(files.resolve("policy-a.onnx"), "changed");
    assertRejected(files, "policy-a.onnx: SHA-256");
    assertEquals(2, Cli.run("benchmark", "check", files).exit(), "a board would believe it");
    assertRejected(
        copy(honest, root -> root.putObject("files").put("../entry.json", "0")), "no such file");
  }

  @Test
  void rejectsPolicyThatReadsFilesOfOthers() throws IOException {
    Path others = Files.writeString(folder.resolve("others.py"), "policy = print");
    Path entry = copy(honest, root -> root.put("policy", "python:" + others));
    assertRejected(entry, "others.py, expected files of the entry alone");
    Files.createSymbolicLink(entry.resolve("policy-others.py"), others);
    edit(entry, root -> root.putObject("files").put("others.py", hash(others)));
    assertRejected(entry, "policy-others.py is a link or no file");
  }

  @Test
  void ranksEachEntryOnceInItsOwnName() throws IOException {
    Path alike = copy(honest, root -> root.put("name", "Tr\u00e0cker"));
    Path greek = copy(honest, root -> root.put("name", "tr\u03b1cker"));
    for (Path other : List.of(honest, alike, greek)) {
      Cli cli =
          Cli.run("benchmark", "leaderboard", honest, other, "--out", folder.resolve("twice"));
      assertEquals(2, cli.exit(), cli.out());
      assertTrue(cli.err().contains("names of two entries look alike, 'tracker'"), cli.err());
    }
  }

  /** The entry has for each seed the better episode of two policies. */
  @Test
  void marksBestOfManyRuns() throws IOException {
    Path other = play("epsilon-greedy");
    Path cheat = copy(honest, root -> {});
    StringBuilder rows = new StringBuilder(rows(honest).findFirst().orElseThrow()).append('\n');
    for (int i = 0; i < 10; i++) {
      boolean isBetter = score(other, i) > score(honest, i);
      double score = Math.max(score(other, i), score(honest, i));
      int episode = i;
      edit(cheat, root -> ((ArrayNode) task(root).get("scores")).set(episode, score));
      rows(isBetter ? other : honest)
          .filter(row -> row.startsWith(1_000_001 + episode + ","))
          .forEach(row -> rows.append(row).append('\n'));
    }
    enterRows(cheat, rows.toString());
    assertEquals(0, Cli.run("benchmark", "check", cheat).exit());
    Cli cli = verify(cheat, folder.resolve("best-verified"));
    assertEquals(1, cli.exit(), cli.out());
    assertTrue(cli.out().contains("the policy scores otherwise in testing"), cli.out());
  }

  @Test
  void rejectsShortSecret() {
    Cli cli =
        Cli.run("benchmark", "verify", honest, "--secret", "a", "--out", folder.resolve("short"));
    assertEquals(2, cli.exit());
    assertTrue(cli.err().contains("--secret has 1 characters, expected 8 or more"), cli.err());
  }

  private static void assertRejected(Path entry, String reason) {
    Cli cli = verify(entry, folder.resolve("rejected"));
    assertEquals(2, cli.exit(), cli.out());
    assertEquals(1, cli.err().lines().count(), cli.err());
    assertTrue(cli.err().contains(reason), cli.err());
  }

  private static double score(Path entry, int episode) throws IOException {
    return MAPPER
        .readTree(entry.resolve("entry.json").toFile())
        .at("/tasks/" + TASK + "/scores/" + episode)
        .asDouble();
  }

  /** Replaces the actions of an entry, and updates their hash. */
  private static void enterRows(Path entry, String rows) throws IOException {
    Path actions = entry.resolve(ACTIONS);
    try (OutputStream out = new GZIPOutputStream(Files.newOutputStream(actions))) {
      out.write(rows.getBytes(StandardCharsets.UTF_8));
    }
    edit(entry, root -> task(root).put("actions", hash(actions)));
  }

  private static String hash(Path file) {
    try {
      return Sha256.of(file);
    } catch (IOException e) {
      throw new AssertionError(e);
    }
  }

  private static Stream<String> rows(Path entry) throws IOException {
    try (InputStream in = new GZIPInputStream(Files.newInputStream(entry.resolve(ACTIONS)))) {
      return new String(in.readAllBytes(), StandardCharsets.UTF_8).lines().toList().stream();
    }
  }

  private static Path copy(Path entry, Consumer<ObjectNode> change) throws IOException {
    Path copy = Files.createTempDirectory(folder, "cheat");
    for (String name : Cli.names(entry)) {
      Files.copy(entry.resolve(name), copy.resolve(name));
    }
    edit(copy, change);
    return copy;
  }

  private static void edit(Path entry, Consumer<ObjectNode> change) throws IOException {
    ObjectNode root = (ObjectNode) MAPPER.readTree(entry.resolve("entry.json").toFile());
    change.accept(root);
    MAPPER.writeValue(entry.resolve("entry.json").toFile(), root);
  }

  private static ObjectNode task(ObjectNode root) {
    return (ObjectNode) root.get("tasks").get(TASK);
  }
}
