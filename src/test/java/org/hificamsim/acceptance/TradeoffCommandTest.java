package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Collections;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.Random;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Tests {@code tradeoff}: its runs equal CamSim's, and its fronts equal those of brute force. */
class TradeoffCommandTest {
  private static final Path SASO = Cli.ROOT.resolve("../shared/reference/camsim/scenarios/SASO");
  private static final Path OWN = Cli.scenario("tutorial-camsim");
  private static final List<String> STRATEGIES = List.of("A0", "A1", "A2", "P0", "P1", "P2");

  @TempDir Path folder;

  @Test
  void networksWriteSameBytesAsCamSim() throws IOException {
    String[] more = {"--heterogeneous", "sample:12", "--bandits", "all", "--alphas", "0.2,0.9"};
    Path out = study(List.of(OWN), 90, 4, more);
    List<String> networks = networks(out);
    assertEquals(6 + 12 + 12, networks.size());
    for (String network : networks) {
      assertSameAsCamSim(out, OWN, network, 90, 4);
    }
  }

  @Test
  void scenariosOfSasoWriteSameBytesAsCamSim() throws IOException {
    assumeTrue(Files.isDirectory(SASO), "without CamSim's scenarios in " + SASO);
    List<Path> files =
        IntStream.rangeClosed(1, 11).mapToObj(i -> SASO.resolve("scenario" + i + ".xml")).toList();
    Path out = study(files, 60, 2, "--heterogeneous", "sample:5", "--bandits", "UCB1,SoftMax");
    int compared = 0;
    for (Path file : files) {
      List<String> networks = new ArrayList<>(networks(out, name(file)));
      Collections.shuffle(networks, new Random(compared));
      for (String network : networks.subList(0, 10)) {
        assertSameAsCamSim(out, file, network, 60, 2);
        compared += 2;
      }
    }
    assertTrue(compared >= 200, compared + " runs compared");
  }

  @Test
  void shardsAndThreadsWriteSameBytes() throws IOException {
    Path whole = study(List.of(OWN), 30, 3, "--heterogeneous", "sample:5", "--threads", "1");
    Object[] words = words(List.of(OWN), 30, 3, "--heterogeneous", "sample:5");
    List<Object> parts = new ArrayList<>();
    for (int i = 1; i <= 2; i++) {
      parts.add(folder.resolve("part" + i));
      run(words, "--shard", i + "/2", "--out", parts.get(i - 1));
    }
    Path merged = folder.resolve("merged");
    run(words, "--out", merged, "--merge", parts.get(0), parts.get(1));
    for (String name : List.of("results.csv", "networks.csv", "fronts.csv", "settings.json")) {
      assertArrayEquals(
          Files.readAllBytes(whole.resolve(name)), Files.readAllBytes(merged.resolve(name)), name);
    }
  }

  @Test
  void resumeReusesOnlyMatchingRuns() throws IOException {
    Path out = study(List.of(OWN), 30, 2);
    Path resumed = folder.resolve("resumed");
    Object[] words = words(List.of(OWN), 30, 2, "--out", resumed);
    run(words, "--shard", "1/2");
    Path journal = resumed.resolve(".compare.journal");
    List<String> lines = Files.readAllLines(resumed.resolve("runs.jsonl"));
    assertEquals(6, lines.size());
    String altered = lines.get(0).replaceFirst("strategies=[AP]", "strategies=HA");
    assertFalse(altered.equals(lines.get(0)));
    Files.write(journal, Stream.concat(lines.stream().skip(1), Stream.of(altered)).toList());
    Cli again = run(words, "--resume");
    assertTrue(again.err().contains("the line is damaged"), again.err());
    assertArrayEquals(
        Files.readAllBytes(out.resolve("results.csv")),
        Files.readAllBytes(resumed.resolve("results.csv")));
  }

  /** Each finished run is written before its thread begins the next one, and is not repeated. */
  @Test
  void killsLoseOnlyUnfinishedRuns() throws Exception {
    Object[] words = words(List.of(OWN), 400, 4, "--heterogeneous", "sample:30", "--threads", "2");
    Path part = folder.resolve("killed");
    Path journal = part.resolve("runs.jsonl");
    List<String> kept = List.of();
    Random random = new Random(40);
    for (int kill = 0; kill < 3; kill++) {
      Object[] again = join(words, "--shard", "1/1", "--resume", "--out", part);
      Process process = Java.main(System.getProperty("java.class.path"), again);
      int enough = kept.size() + 1 + random.nextInt(35);
      while (process.isAlive() && completeLines(journal).size() < enough) {
        Thread.sleep(1);
      }
      process.destroyForcibly().waitFor();
      List<String> now = completeLines(journal);
      assertEquals(kept, now.subList(0, kept.size()), "what was finished is not done again");
      kept = now;
    }
    assertTrue(kept.size() >= 3 && kept.size() < 144, kept.size() + " runs before the last call");
    run(words, "--shard", "1/1", "--resume", "--out", part);
    List<String> all = completeLines(journal);
    assertEquals(kept, all.subList(0, kept.size()));
    assertEquals(144, all.size());
    Path merged = folder.resolve("merged");
    run(words, "--merge", part, "--out", merged);
    Path never = folder.resolve("never-killed");
    run(words, "--out", never);
    for (String name : List.of("results.csv", "networks.csv", "fronts.csv", "verdicts.csv")) {
      assertArrayEquals(
          Files.readAllBytes(never.resolve(name)), Files.readAllBytes(merged.resolve(name)), name);
    }
  }

  /** Returns the lines of a journal without an incomplete last one. */
  private static List<String> completeLines(Path journal) throws IOException {
    String text = Files.exists(journal) ? Files.readString(journal) : "";
    return text.substring(0, text.lastIndexOf('\n') + 1).lines().toList();
  }

  @Test
  void judgesPapersByNetworksOfAllScenarios() throws IOException {
    List<Path> files = List.of(OWN, Cli.ROOT.resolve("scenarios/studies/yard.xml"));
    String[] more = {"--heterogeneous", "sample:12", "--bandits", "UCB1,SoftMax"};
    Path out = study(files, 80, 5, more);
    Map<String, List<Double>> gains = new TreeMap<>();
    Map<String, List<Double>> volumes = new TreeMap<>();
    for (String[] row : rows(out.resolve("fronts.csv"))) {
      volumes.computeIfAbsent(row[2], set -> new ArrayList<>()).add(Double.valueOf(row[5]));
      gains.computeIfAbsent(row[2], set -> new ArrayList<>()).add(Double.valueOf(row[8]));
    }
    double near = 1;
    double beyond = -1;
    for (int i = 0; i < files.size(); i++) {
      double frontOfStatic = volumes.get("static").get(i);
      near = Math.min(near, 0.05 + volumes.get("bandit").get(i) - frontOfStatic);
      beyond = Math.max(beyond, volumes.get("all").get(i) - frontOfStatic);
    }
    assertVerdict(out, "heterogeneous-extend", Collections.min(gains.get("static")));
    assertVerdict(out, "bandits-near", near);
    assertVerdict(out, "bandits-extend", Collections.max(gains.get("adaptive")));
    assertVerdict(out, "bandits-beyond", beyond);
    List<Map<String, Double>> areas = files.stream().map(file -> areas(out, file)).toList();
    String best =
        STRATEGIES.stream()
            .max(Comparator.comparing(name -> areas.get(0).get(name) + areas.get(1).get(name)))
            .orElseThrow();
    double lead =
        areas.stream()
            .mapToDouble(
                own ->
                    STRATEGIES.stream()
                            .filter(name -> !name.equals(best))
                            .mapToDouble(own::get)
                            .max()
                            .orElseThrow()
                        - own.get(best))
            .max()
            .orElseThrow();
    assertVerdict(out, "best-depends", lead);
    Path alone = study(List.of(OWN), 30, 2);
    assertEquals(1, Files.readAllLines(alone.resolve("verdicts.csv")).size());
  }

  private static Map<String, Double> areas(Path out, Path file) {
    try {
      return networkRows(out, file).stream()
          .filter(row -> STRATEGIES.contains(row[3]))
          .collect(
              Collectors.toMap(
                  row -> row[3],
                  row -> Double.parseDouble(row[10]) * (1 - Double.parseDouble(row[11]))));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static void assertVerdict(Path out, String id, double margin) throws IOException {
    String row =
        Files.readAllLines(out.resolve("verdicts.csv")).stream()
            .filter(line -> line.startsWith("statement," + id + ","))
            .findFirst()
            .orElseThrow();
    String[] numbers = row.substring(row.indexOf(".,,") + 3).split(",");
    assertEquals(margin, Double.parseDouble(numbers[0]), 1e-9, row);
    double low = Double.parseDouble(numbers[1]);
    double high = Double.parseDouble(numbers[2]);
    String verdict = low > 0 ? "reproduced" : high < 0 ? "not reproduced" : "within interval";
    assertTrue(Integer.parseInt(numbers[3]) > 1 || verdict.equals(numbers[5]), row);
    assertFalse(verdict.equals("not reproduced") && !numbers[5].equals(verdict), row);
  }

  @Test
  void frontEqualsBruteForce() throws IOException {
    Path out = study(List.of(OWN), 60, 3, "--heterogeneous", "all");
    List<String[]> rows = rows(out.resolve("networks.csv"));
    assertEquals(216, rows.size());
    List<String> front =
        rows.stream()
            .filter(row -> rows.stream().noneMatch(other -> beats(other, row)))
            .map(row -> row[3])
            .sorted()
            .toList();
    String[] all = rows(out.resolve("fronts.csv")).get(1);
    assertEquals("static", all[2]);
    assertEquals(front, Stream.of(all[11].split(" ")).sorted().toList());
    for (String[] row : rows) {
      assertTrue(!front.contains(row[3]) || Double.parseDouble(row[12]) <= 0, row[3]);
    }
  }

  @Test
  void searchFindsFrontWithTenthOfRuns() throws IOException {
    List<Path> files = List.of(OWN, Cli.ROOT.resolve("scenarios/studies/yard.xml"));
    Path all = study(files, 150, 3, "--heterogeneous", "all");
    Path found = study(files, 150, 3, "--heterogeneous", "search:21");
    for (Path file : files) {
      List<String[]> full = networkRows(all, file);
      List<String[]> some = networkRows(found, file);
      assertTrue(some.size() <= 27, some.size() + " networks");
      double share = hypervolume(some, full) / hypervolume(full, full);
      assertTrue(share >= 0.99, file + ": " + share);
    }
    assertArrayEquals(
        Files.readAllBytes(found.resolve("results.csv")),
        Files.readAllBytes(
            study(files, 150, 3, "--heterogeneous", "search:21", "--threads", "1")
                .resolve("results.csv")));
  }

  private static List<String[]> networkRows(Path out, Path file) throws IOException {
    return rows(out.resolve("networks.csv")).stream()
        .filter(row -> row[0].equals(name(file)))
        .toList();
  }

  /** Returns the share of a fine grid of utilities and costs that at least one network beats. */
  private static double hypervolume(List<String[]> rows, List<String[]> scale) {
    double[][] networks = utilitiesAndCosts(rows);
    double[][] all = utilitiesAndCosts(scale);
    double utility = Arrays.stream(all).mapToDouble(network -> network[0]).max().orElse(0);
    double cost = Arrays.stream(all).mapToDouble(network -> network[1]).max().orElse(0);
    long beaten = 0;
    for (int i = 0; i < 400 * 400; i++) {
      int row = i / 400;
      double u = (row + 0.5) / 400 * utility;
      double c = (i % 400 + 0.5) / 400 * cost;
      if (Arrays.stream(networks).anyMatch(network -> network[0] >= u && network[1] <= c)) {
        beaten++;
      }
    }
    return beaten / (400.0 * 400);
  }

  private static double[][] utilitiesAndCosts(List<String[]> rows) {
    return rows.stream()
        .map(row -> new double[] {Double.parseDouble(row[4]), Double.parseDouble(row[7])})
        .toArray(double[][]::new);
  }

  @Test
  void reportHasPictureAndReplaysOfTheStudy() throws IOException {
    Path out = study(List.of(OWN), 40, 2, "--channel", "loss=0.2");
    Cli report = Cli.run("report", out, "--replays");
    assertEquals(0, report.exit(), report.err());
    assertTrue(Files.size(out.resolve("tradeoff.png")) > 3000);
    String page = Files.readString(out.resolve("report.html"));
    String front = rows(out.resolve("fronts.csv")).get(0)[11];
    for (String network : front.split(" ")) {
      String replay = "replay-tutorial-camsim-" + network;
      assertTrue(page.contains(replay + "/report.html"), network);
      String summary = Files.readString(out.resolve(replay).resolve("summary.json"));
      String[] run =
          rows(out.resolve("results.csv")).stream()
              .filter(row -> row[15].equals(network) && row[3].equals("5"))
              .findFirst()
              .orElseThrow();
      assertTrue(summary.contains("\"utility\" : " + run[16]), run[16] + " in " + summary);
    }
  }

  @Test
  void channelAndDetectionChangeResults() throws IOException {
    Path plain = study(List.of(OWN), 60, 2);
    Path real = study(List.of(OWN), 60, 2, "--detection", "hifi:orb-lin", "--detect", "chance");
    Path lossy = study(List.of(OWN), 60, 2, "--channel", "loss=0.5,delay=2");
    assertFalse(values(plain).equals(values(real)));
    assertFalse(values(plain).equals(values(lossy)));
    assertSameAsCamSim(lossy, OWN, "P1", 60, 2, "--channel", "loss=0.5,delay=2");
  }

  @ParameterizedTest
  @CsvSource(
      delimiter = '|',
      value = {
        "--of A0,A7 | strategies are 'A7', expected A, P, HA or HP",
        "--of A0,A0 | 'A0' twice",
        "--heterogeneous some | --heterogeneous is 'some', expected none, all, sample:N",
        "--bandits Greedy | bandit is 'Greedy', expected one of",
        "--alphas 2 | --alphas is 2.0, expected",
        "--heterogeneous search:9 --shard 1/2 | search has no parts",
        "--detection nothing | unknown detection 'nothing'",
      })
  void rejectsWrongUsageInOneLine(String options, String expected) {
    Cli.assertRejects(options, expected, folder.resolve("out"), "tradeoff", OWN);
  }

  private Path study(List<Path> files, int steps, int seeds, String... more) throws IOException {
    Path out = Files.createTempDirectory(folder, "study").resolve("out");
    run(words(files, steps, seeds, (Object[]) more), "--out", out, "--camsim-files");
    return out;
  }

  private static Object[] words(List<Path> files, int steps, int seeds, Object... more) {
    Stream<Object> command =
        Stream.of("tradeoff", "--steps", steps, "--repeat", seeds, "--seed", 5);
    return Stream.of(command, files.stream(), Arrays.stream(more))
        .flatMap(words -> words)
        .toArray();
  }

  private static Object[] join(Object[] words, Object... more) {
    return Stream.concat(Arrays.stream(words), Arrays.stream(more)).toArray();
  }

  private static Cli run(Object[] words, Object... more) {
    Cli run = Cli.run(join(words, more));
    assertEquals(0, run.exit(), run.err());
    return run;
  }

  private void assertSameAsCamSim(
      Path out, Path file, String network, int steps, int seeds, String... more)
      throws IOException {
    Path own = Files.createTempDirectory(folder, "camsim");
    List<Object> words =
        new ArrayList<>(
            List.of("camsim", file, "-s", 5, "--repeat", seeds, "-o", own.resolve("output.csv")));
    words.addAll(List.of("-t", steps, "-f", own.resolve("summary.csv")));
    if (network.contains("@")) {
      Path parameters = own.resolve("parameters");
      Files.writeString(parameters, "Alpha=" + network.split("@")[1]);
      words.addAll(List.of("-b", network.split("@")[0], "-p", parameters));
    } else if (STRATEGIES.contains(network)) {
      words.addAll(List.of("-a", network.startsWith("A") ? "Active" : "Passive"));
      words.addAll(List.of("-c", network.substring(1)));
    } else {
      words.addAll(List.of("--strategies", network));
    }
    run(words.toArray(), (Object[]) more);
    assertArrayEquals(
        Files.readAllBytes(own.resolve("summary-" + name(file) + ".csv")),
        Files.readAllBytes(out.resolve("summary-" + name(file) + "-" + network + ".csv")),
        name(file) + " " + network);
  }

  private static String name(Path file) {
    return file.getFileName().toString().replace(".xml", "");
  }

  private static boolean beats(String[] one, String[] other) {
    double utility = Double.parseDouble(one[4]) - Double.parseDouble(other[4]);
    double cost = Double.parseDouble(other[7]) - Double.parseDouble(one[7]);
    return utility >= 0 && cost >= 0 && utility + cost > 0;
  }

  private static List<String> networks(Path out) throws IOException {
    return rows(out.resolve("networks.csv")).stream().map(row -> row[3]).toList();
  }

  private static List<String> networks(Path out, String scenario) throws IOException {
    return rows(out.resolve("networks.csv")).stream()
        .filter(row -> row[0].equals(scenario))
        .map(row -> row[3])
        .toList();
  }

  private static List<String> values(Path out) throws IOException {
    return rows(out.resolve("networks.csv")).stream().map(row -> row[4] + " " + row[7]).toList();
  }

  private static List<String[]> rows(Path file) throws IOException {
    return Files.readAllLines(file).stream().skip(1).map(line -> line.split(",", -1)).toList();
  }
}
