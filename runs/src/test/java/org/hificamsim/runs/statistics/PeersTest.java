package org.hificamsim.runs.statistics;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.io.InputStream;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.hificamsim.runs.Estimate;
import org.junit.jupiter.api.BeforeAll;
import org.junit.jupiter.api.Test;

/**
 * Compares statistics with those of rliable and SciPy for the same scores: with the recorded
 * results of rliable 1.2.0 and SciPy 1.17 in {@code peers.json}, or with those of a Python
 * interpreter that the variable HIFICAMSIM_PYTHON names ({@code pip install rliable 'pandas<3'}).
 */
class PeersTest {
  private static final Optional<String> PYTHON =
      Optional.ofNullable(System.getenv("HIFICAMSIM_PYTHON"));
  private static final ObjectMapper JSON = new ObjectMapper();
  private static final int SEEDS = 30;
  private static final double ROUNDING = 1e-12;

  private static final Strata X = scores(0.7, 1);
  private static final Strata Y = scores(0.66, 2);
  private static JsonNode peers;

  @BeforeAll
  static void readResultsOfPeers() throws Exception {
    ObjectNode question = JSON.createObjectNode().put("few", PairedTest.MAX_EXACT - 4);
    question.putPOJO("x", X.scores());
    question.putPOJO("y", Y.scores());
    question.putPOJO("taus", Aggregate.TAUS);
    JsonNode scoresAsJson = JSON.readTree(JSON.writeValueAsBytes(question));
    if (PYTHON.isPresent()) {
      peers = answer(scoresAsJson);
      return;
    }
    try (InputStream recorded = PeersTest.class.getResourceAsStream("peers.json")) {
      JsonNode both = JSON.readTree(recorded);
      assertEquals(both.get("question"), scoresAsJson, "recorded of other scores");
      peers = both.get("answer");
    }
  }

  @Test
  void aggregatesAgreeWithRliable() {
    Aggregate[] aggregates = Aggregate.values();
    for (int i = 0; i < aggregates.length; i++) {
      Estimate ours = Aggregate.estimates(X).get(aggregates[i]);
      assertEquals(peers.at("/aggregates/" + i).asDouble(), ours.mean(), ROUNDING);
      assertClose(peers.at("/ends/0/" + i), peers.at("/ends/1/" + i), ours);
    }
  }

  @Test
  void probabilityOfImprovementAgreesWithRliable() {
    Estimate ours = Aggregate.improvement(X, Y);
    assertEquals(peers.at("/improvement/0").asDouble(), ours.mean(), ROUNDING);
    assertClose(peers.at("/improvementEnds/0"), peers.at("/improvementEnds/1"), ours);
  }

  /** Wilson's intervals ignore that scenarios differ, and are therefore longer. */
  @Test
  void profileContainsIntervalsOfRliable() {
    Estimate[] ours = Aggregate.profile(X);
    for (int i = 0; i < Aggregate.TAUS.length; i++) {
      Estimate share = ours[i];
      assertEquals(peers.at("/profile/" + i).asDouble(), share.mean(), ROUNDING);
      double low = peers.at("/profileEnds/0/" + i).asDouble();
      double high = peers.at("/profileEnds/1/" + i).asDouble();
      assertTrue(share.low() < low + 0.02 && share.high() > high - 0.02);
      assertTrue(share.high() - share.low() < 0.22);
    }
  }

  @Test
  void pValuesAgreeWithSciPy() {
    double[] differences = new double[SEEDS];
    Arrays.setAll(differences, i -> X.scores()[0][i] - Y.scores()[0][i]);
    double[] few = Arrays.copyOf(differences, PairedTest.MAX_EXACT - 4);
    assertEquals(peers.at("/exact").asDouble(), PairedTest.p(few), ROUNDING);
    assertEquals(peers.at("/drawn").asDouble(), PairedTest.p(differences), 0.005);
  }

  /** Compares ends of intervals, which depend on draws, to a tenth of their width. */
  private static void assertClose(JsonNode low, JsonNode high, Estimate ours) {
    double width = high.asDouble() - low.asDouble();
    assertTrue(width > 0);
    assertEquals(low.asDouble(), ours.low(), 0.1 * width);
    assertEquals(high.asDouble(), ours.high(), 0.1 * width);
  }

  private static Strata scores(double level, long seed) {
    SplittableRandom random = new SplittableRandom(seed);
    return Strata.of(
        IntStream.range(0, 3)
            .mapToObj(
                scenario ->
                    random
                        .doubles(SEEDS)
                        .map(noise -> Math.min(0.9999, level + 0.1 * scenario + 0.3 * (noise - .5)))
                        .toArray())
            .toList());
  }

  private static JsonNode answer(JsonNode question) throws Exception {
    Process python;
    try (InputStream script = PeersTest.class.getResourceAsStream("peers.py")) {
      String text = new String(script.readAllBytes(), StandardCharsets.UTF_8);
      python =
          new ProcessBuilder(PYTHON.orElseThrow(), "-c", text)
              .redirectError(ProcessBuilder.Redirect.DISCARD)
              .start();
    }
    try (var in = python.getOutputStream()) {
      in.write(JSON.writeValueAsBytes(question));
    }
    byte[] answer = python.getInputStream().readAllBytes();
    assertEquals(0, python.waitFor());
    return JSON.readTree(answer);
  }
}
