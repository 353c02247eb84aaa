package org.hificamsim.agents.search;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.stream.IntStream;
import java.util.stream.LongStream;
import java.util.stream.Stream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.MethodSource;

/** Of six cameras. */
class WorthTest {
  private static final int CAMERAS = 6;
  private static final long UNIT = Worth.UNIT;

  @Test
  void aTargetIsWorthAUnitOnceEnoughCamerasCoverIt() {
    Worth worth = new Worth(CAMERAS);
    worth.whereCovered(3);
    assertEquals("0 0 0 1 1 1 1", units(worth));
    assertEquals(3, worth.top());
    worth.whereCovered(99);
    assertEquals("0 0 0 0 0 0 0", units(worth));
    assertEquals(UNIT, worth.step());
  }

  @Test
  void eachCameraIsWorthAUnitUpToTheCap() {
    Worth worth = new Worth(CAMERAS);
    worth.ofEachUpTo(4);
    assertEquals("0 1 2 3 4 4 4", units(worth));
    worth.ofEachUpTo(99);
    assertEquals("0 1 2 3 4 5 6", units(worth));
  }

  @Test
  void whatIsCoveredLessOutweighsAllThatFollows() {
    Worth worth = new Worth(CAMERAS);
    worth.ofEachUpTo(6);
    worth.falling(1, 3, 10);
    long[] expected = {0, 0, 100, 110, 111, 111, 111};
    assertEquals(text(LongStream.of(expected)), text(values(worth)));
    assertEquals(4, worth.top());
    assertEquals(1, worth.step());
  }

  static Stream<Worth> worths() {
    Stream<Worth> covered =
        IntStream.of(1, 2, 3, 6, 99).mapToObj(enough -> made(one -> one.whereCovered(enough)));
    Stream<Worth> sums = IntStream.of(1, 3, 99).mapToObj(cap -> made(one -> one.ofEachUpTo(cap)));
    Stream<Worth> falling =
        IntStream.of(0, 2).mapToObj(from -> made(one -> one.falling(from, 4, UNIT)));
    return Stream.of(covered, sums, falling).flatMap(one -> one);
  }

  private static Worth made(java.util.function.Consumer<Worth> fill) {
    Worth worth = new Worth(CAMERAS);
    fill.accept(worth);
    return worth;
  }

  @ParameterizedTest
  @MethodSource("worths")
  void whatItGainsByBuyingIsTheMostOfAllNumbersOfCameras(Worth worth) {
    for (long price : new long[] {0, 1, UNIT / 3, UNIT / 2, UNIT, 2 * UNIT, UNIT * UNIT}) {
      for (int k = 0; k <= CAMERAS; k++) {
        for (int supply = 0; k + supply <= CAMERAS; supply++) {
          int from = k;
          long most =
              IntStream.rangeClosed(0, supply)
                  .mapToLong(y -> worth.of(from + y) - price * y)
                  .max()
                  .orElseThrow();
          assertEquals(most, worth.surplus(k, supply, price));
        }
        int bought = worth.bought(k, price);
        assertEquals(worth.surplus(0, k, price), worth.of(bought) - price * bought);
        assertEquals(bought == 0, worth.surplus(0, k, price) == 0, "none rather than for nothing");
      }
    }
  }

  @ParameterizedTest
  @MethodSource("worths")
  void theSlopeIsTheLeastPriceAtWhichNothingIsGained(Worth worth) {
    for (int k = 0; k <= CAMERAS; k++) {
      for (int supply = 0; k + supply <= CAMERAS; supply++) {
        long slope = worth.slope(k, supply);
        assertEquals(worth.of(k), worth.surplus(k, supply, slope));
        assertEquals(slope > 0, slope > 0 && worth.surplus(k, supply, slope - 1) > worth.of(k));
      }
    }
  }

  private static LongStream values(Worth worth) {
    return IntStream.rangeClosed(0, CAMERAS).mapToLong(worth::of);
  }

  private static String units(Worth worth) {
    return text(values(worth).map(value -> value / UNIT));
  }

  private static String text(LongStream numbers) {
    return String.join(" ", numbers.mapToObj(Long::toString).toList());
  }
}
