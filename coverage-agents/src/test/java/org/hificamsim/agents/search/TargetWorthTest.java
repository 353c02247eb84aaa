package org.hificamsim.agents.search;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Of six cameras. */
class TargetWorthTest {
  private static final int CAMERAS = 6;
  private static final long UNIT = new TargetWorth(new long[] {0, 1}, 1).unit();

  @Test
  void aUnitIsWhatSixteenNumbersDivideUnlessSumsGetTooLarge() {
    IntStream.rangeClosed(1, 16).forEach(number -> assertEquals(0, UNIT % number));
    assertEquals(1, new TargetWorth(new long[] {0, 1L << 40}, 100).unit());
  }

  @Test
  void itIsFlatFromWhereNoCameraAddsAnything() {
    TargetWorth worth = new TargetWorth(new long[] {0, 0, 1, 1}, 1);
    assertEquals(2, worth.saturation());
    assertEquals("0 0 1 1 1", units(worth, 4));
    assertEquals(0, worth.gain(0));
    assertEquals(UNIT, worth.gain(1));
    assertEquals(0, worth.gain(2));
  }

  @Test
  void itCanBeCutOffAndBeWholeAgain() {
    TargetWorth worth = new TargetWorth(new long[] {0, 1, 2, 3}, 1);
    worth.cut(1);
    assertEquals("0 1 1 1", units(worth, 3));
    worth.cut(3);
    assertEquals("0 1 2 3", units(worth, 3));
  }

  static Stream<TargetWorth> worths() {
    Stream<TargetWorth> tables =
        Stream.of(
                new long[] {0, 1, 1, 1, 1, 1, 1},
                new long[] {0, 0, 1, 1, 1, 1, 1},
                new long[] {0, 0, 0, 0, 0, 1, 1},
                new long[] {0, 1, 2, 3, 3, 3, 3},
                new long[] {0, 0, 100, 110, 111, 111, 111},
                new long[] {0, 0, 1, 3, 3, 4, 9},
                new long[CAMERAS + 1])
            .map(table -> new TargetWorth(table, 1));
    TargetWorth cut = new TargetWorth(new long[] {0, 1, 2, 3, 4, 5, 6}, 1);
    cut.cut(4);
    return Stream.concat(tables, Stream.of(cut));
  }

  @ParameterizedTest
  @MethodSource("worths")
  void theProfitIsTheMostOfAllNumbersOfCameras(TargetWorth worth) {
    for (long price : new long[] {0, 1, UNIT / 3, UNIT / 2, UNIT, 2 * UNIT, UNIT * UNIT}) {
      for (int k = 0; k <= CAMERAS; k++) {
        for (int most = k; most <= CAMERAS; most++) {
          long profit =
              IntStream.rangeClosed(k, most)
                  .mapToLong(y -> worth.of(y) - price * y)
                  .max()
                  .orElseThrow();
          assertEquals(profit, worth.profit(k, most, price));
        }
        int bought = worth.demand(k, price);
        assertEquals(worth.profit(0, k, price), worth.of(bought) - price * bought);
        assertEquals(bought == 0, worth.profit(0, k, price) == 0, "none rather than for nothing");
      }
    }
  }

  @ParameterizedTest
  @MethodSource("worths")
  void theSlopeIsTheLeastPriceAtWhichNothingIsGained(TargetWorth worth) {
    for (int k = 0; k <= CAMERAS; k++) {
      for (int supply = k; supply <= CAMERAS; supply++) {
        long slope = worth.slope(k, supply);
        assertEquals(worth.of(k) - slope * k, worth.profit(k, supply, slope));
        boolean gains = worth.profit(k, supply, slope - 1) > worth.of(k) - (slope - 1) * k;
        assertEquals(slope > 0, slope > 0 && gains);
      }
    }
  }

  private static String units(TargetWorth worth, int most) {
    return String.join(
        " ",
        LongStream.rangeClosed(0, most)
            .mapToObj(k -> Long.toString(worth.of((int) k) / UNIT))
            .toList());
  }
}
