package org.hificamsim.runs.statistics;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.Arrays;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

class StrataTest {
  private static final Strata STRATA =
      Strata.of(
          List.of(
              new double[] {0.5, -0.0, 0.0, 0.5, Double.NaN, 0.25},
              new double[0],
              new double[] {Double.POSITIVE_INFINITY, 0.5, 0.0},
              new double[] {Double.NaN}));

  @Test
  void sortsScoresAndDrawnScores() {
    SplittableRandom random = new SplittableRandom(1);
    for (int i = 0; i < 100; i++) {
      assertSorts(STRATA.drawn(random));
    }
    assertSorts(STRATA);
  }

  private static void assertSorts(Strata strata) {
    double[] all =
        Arrays.stream(strata.scores()).flatMapToDouble(Arrays::stream).sorted().toArray();
    assertArrayEquals(bits(all), bits(strata.sorted()));
    for (int scenario = 0; scenario < strata.scores().length; scenario++) {
      double[] scores = strata.scores()[scenario].clone();
      Arrays.sort(scores);
      assertArrayEquals(bits(scores), bits(strata.sortedByScenario()[scenario]));
    }
  }

  private static long[] bits(double[] scores) {
    return Arrays.stream(scores).mapToLong(Double::doubleToRawLongBits).toArray();
  }

  @Test
  void drawsScoresWithinTheirScenario() {
    SplittableRandom expected = new SplittableRandom(7);
    double[][] drawn = STRATA.drawn(new SplittableRandom(7)).scores();
    for (int scenario = 0; scenario < drawn.length; scenario++) {
      double[] scores = STRATA.scores()[scenario];
      for (double score : drawn[scenario]) {
        assertEquals(scores[expected.nextInt(scores.length)], score);
      }
    }
  }

  @Test
  void omitsMissingScores() {
    assertEquals(8, STRATA.runs());
    assertEquals(2, STRATA.scenarios());
  }
}
