package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertNotEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.DoubleStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/** Tests {@code --channel}: votes and auctions over a channel that loses and delays messages. */
class ChannelCommandTest {
  private static final int COMMUNICATION = 2;
  private static final int PROPORTION = 9;

  @TempDir Path folder;

  private Path run(String name, String options) {
    Path out = folder.resolve(name);
    List<Object> words = new ArrayList<>(List.of("run", Cli.scenario("ring-random")));
    words.addAll(List.of("--steps", 120, "--repeat", 2, "--out", out));
    words.addAll(List.of(options.split(" ")));
    Cli run = Cli.run(words.toArray());
    assertEquals(0, run.exit(), run.err());
    return out;
  }

  private static String steps(Path out) throws IOException {
    return Files.readString(out.resolve("steps.csv"));
  }

  private static JsonNode first(Path out) throws IOException {
    return new ObjectMapper().readTree(out.resolve("summary.json").toFile()).at("/runs/0");
  }

  /** These channels lose and delay nothing, but are not perfect for the program. */
  @ParameterizedTest
  @ValueSource(strings = {"range=1000", "bandwidth=1000000"})
  void losslessChannelChangesNothing(String channel) throws IOException {
    Path plain = run("plain", "--policy qb-sarsa");
    Path overChannel = run("over", "--policy qb-sarsa --channel " + channel);
    assertEquals(steps(plain), steps(overChannel));
    for (String metric : List.of("messages", "bits")) {
      assertEquals(first(plain).get(metric), first(overChannel).get(metric));
    }
    assertEquals(0, first(overChannel).get("messages_dropped").asInt());
    assertTrue(first(plain).path("messages_dropped").isMissingNode());
  }

  @Test
  void votersLearnIndependentlyIfNothingArrives() throws IOException {
    assertEquals(
        steps(run("alone", "--policy sarsa")),
        steps(run("deaf", "--policy qb-sarsa --channel loss=1")));
  }

  @Test
  void channelLosesTheSameMessagesAgain() throws IOException {
    String options = "--policy qb-sarsa --channel loss=0.3,burst=4,delay=0..3,range=8";
    Path first = run("one", options);
    assertEquals(steps(first), steps(run("again", options)));
    assertNotEquals(steps(first), steps(run("plain", "--policy qb-sarsa")));
  }

  @Test
  void cooperativeRunsAreReproducible() throws IOException {
    List<String> steps = new ArrayList<>();
    for (String options :
        List.of("--channel loss=0.3,delay=1", "--channel loss=0.3,delay=1", "--quiet", "--quiet")) {
      Path out = folder.resolve("run" + steps.size());
      List<Object> words = new ArrayList<>(List.of("run", Cli.scenario("corridor")));
      words.addAll(List.of("--steps", 40, "--repeat", 2, "--policy", "cooperative:cells=200"));
      words.addAll(List.of("--out", out));
      words.addAll(List.of(options.split(" ")));
      Cli run = Cli.run(words.toArray());
      assertEquals(0, run.exit(), run.err());
      steps.add(steps(out));
    }
    assertEquals(steps.get(0), steps.get(1));
    assertEquals(steps.get(2), steps.get(3));
    assertNotEquals(steps.get(0), steps.get(2));
  }

  @Test
  void lateAnswerCountsUntilTheTimeOut() throws IOException {
    String late = "--policy qb-sarsa:state=none,timeout=%s --channel delay=3";
    Path alone = run("alone", "--policy sarsa:state=none");
    assertEquals(steps(alone), steps(run("short", late.formatted(5))));
    assertNotEquals(steps(alone), steps(run("long", late.formatted(6))));
  }

  @Test
  void optionOverridesScenario() throws IOException {
    Path scenario = folder.resolve("lossy.xml");
    String text = Files.readString(Cli.scenario("ring-random"));
    Files.writeString(scenario, text.replaceFirst("<simulation", "$0 channel=\"loss=1\""));
    Path out = folder.resolve("out");
    Cli.run("run", scenario, "--steps", 50, "--policy", "qb-sarsa", "--out", out);
    int lost = first(out).get("messages").asInt();
    Cli.run(
        "run",
        scenario,
        "--steps",
        50,
        "--policy",
        "qb-sarsa",
        "--channel",
        "perfect",
        "--out",
        out);
    assertEquals(2 * lost, first(out).get("messages").asInt());
  }

  @Test
  void rejectsInvalidChannelsInOneLine() {
    Cli.assertRejects(
        "--channel delay=soon",
        "channel: delay is 'soon', expected steps up to 10000, as 2, 1..5 or exponential:2",
        folder.resolve("refused"),
        "run",
        Cli.scenario("ring-random"));
  }

  /** Runs CamSim's auctions, and returns their table. */
  private String auctions(String name, String channel) throws IOException {
    Path out = folder.resolve(name);
    Cli run =
        Cli.run(
            "camsim", Cli.scenario("tutorial-camsim"), "-t", 200, "-o", out, "--channel", channel);
    assertEquals(0, run.exit(), run.err());
    return Files.readString(out);
  }

  private static double[] column(String table, int column) {
    return table
        .lines()
        .skip(1)
        .mapToDouble(row -> Double.parseDouble(row.split(";")[column]))
        .toArray();
  }

  @Test
  void losslessChannelDoesNotChangeAuctions() throws IOException {
    assertEquals(auctions("plain.csv", "perfect"), auctions("over.csv", "range=100000"));
  }

  @Test
  void camerasWithoutMessagesOwnWhatTheySee() throws IOException {
    String perfect = auctions("0.csv", "perfect");
    String deaf = auctions("1.csv", "loss=1");
    assertEquals(0, DoubleStream.of(column(deaf, COMMUNICATION)).sum());
    assertTrue(DoubleStream.of(column(deaf, PROPORTION)).max().orElseThrow() > 1);
    assertEquals(1, DoubleStream.of(column(perfect, PROPORTION)).max().orElseThrow());
  }

  @Test
  void acceptsLateBids() throws IOException {
    String late = auctions("late.csv", "delay=2");
    assertNotEquals(auctions("perfect.csv", "perfect"), late);
    assertTrue(DoubleStream.of(column(late, COMMUNICATION)).sum() > 0);
  }
}
