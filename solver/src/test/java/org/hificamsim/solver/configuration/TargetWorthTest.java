package org.hificamsim.solver.configuration;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

class TargetWorthTest {
  private static final int CAMERAS = 6;
  private static final long UNIT = new TargetWorth(new long[] {0, 1}, 1).unit();

  @Test
  void unitIsDivisibleUnlessSumsGetTooLarge() {
    IntStream.rangeClosed(1, 16).forEach(number -> assertEquals(0, UNIT % number));
    assertEquals(1, new TargetWorth(new long[] {0, 1L << 40}, 100).unit());
  }

  @Test
  void isConstantFromSaturationOn() {
    TargetWorth worth = new TargetWorth(new long[] {0, 0, 1, 1}, 1);
    assertEquals(2, worth.saturation());
    assertEquals("0 0 1 1 1", units(worth, 4));
    assertEquals(0, worth.gain(0));
    assertEquals(UNIT, worth.gain(1));
    assertEquals(0, worth.gain(2));
  }

  @Test
  void newCutReplacesEarlierOne() {
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
  void profitIsTheGreatestOfAllNumbersOfCameras(TargetWorth worth) {
    for (long price : new long[] {0, 1, UNIT / 3, UNIT / 2, UNIT, 2 * UNIT, UNIT * UNIT}) {
      for (int k = 0; k <= CAMERAS; k++) {
        for (int max = k; max <= CAMERAS; max++) {
          long profit =
              IntStream.rangeClosed(k, max)
                  .mapToLong(bought -> worth.value(bought) - price * bought)
                  .max()
                  .orElseThrow();
          assertEquals(profit, worth.profit(k, max, price));
        }
        int demand = worth.demand(k, price);
        assertEquals(worth.profit(0, k, price), worth.value(demand) - price * demand);
        assertEquals(demand == 0, worth.profit(0, k, price) == 0, "buys none without profit");
      }
    }
  }

  @ParameterizedTest
  @MethodSource("worths")
  void slopeIsTheLeastPriceWithoutProfit(TargetWorth worth) {
    for (int k = 0; k <= CAMERAS; k++) {
      for (int max = k; max <= CAMERAS; max++) {
        long slope = worth.slope(k, max);
        assertEquals(worth.value(k) - slope * k, worth.profit(k, max, slope));
        boolean gains = worth.profit(k, max, slope - 1) > worth.value(k) - (slope - 1) * k;
        assertEquals(slope > 0, slope > 0 && gains);
      }
    }
  }

  private static String units(TargetWorth worth, int maxCameras) {
    return String.join(
        " ",
        LongStream.rangeClosed(0, maxCameras)
            .mapToObj(k -> Long.toString(worth.value((int) k) / UNIT))
            .toList());
  }
}
