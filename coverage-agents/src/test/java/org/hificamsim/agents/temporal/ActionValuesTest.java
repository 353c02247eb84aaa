package org.hificamsim.agents.temporal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.Arrays;
import java.util.HashMap;
import java.util.Map;
import java.util.SplittableRandom;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.hificamsim.agents.choice.Ties;
import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.InputException;
import org.junit.jupiter.api.Test;

class ActionValuesTest {
  /** So many cameras, levels and targets that tables do not have all their states at first. */
  private static final int CAMERAS = 40;

  private static final int LEVELS = 5;
  private static final int TARGETS = 4_000;

  @Property(tries = 200)
  void theBestActionIsFoundAfterAnyUpdates(
      @ForAll @IntRange(min = 1, max = 6) int levels, @ForAll Ties ties, @ForAll long seed) {
    ActionValues values =
        new ActionValues(new ToyNetwork(2, levels), settings(StateReading.COUNT, 0, ties));
    SplittableRandom random = new SplittableRandom(seed);
    double[] plain = new double[levels];
    for (int i = 0; i < 100; i++) {
      int action = random.nextInt(levels);
      plain[action] = random.nextInt(-3, 4); // few values, so that many are equal
      values.set(0, 1, action, plain[action]);
      assertEquals(ties.best(plain, 0, levels), values.best(0, 1), "update " + i);
    }
  }

  @Property(tries = 20)
  void tablesThatGrowHoldWhatAWholeTableWould(
      @ForAll StateReading reading, @ForAll Ties ties, @ForAll long seed) {
    ActionValues values = new ActionValues(bigNetwork(), settings(reading, -1, ties));
    SplittableRandom random = new SplittableRandom(seed);
    Map<Integer, double[]> plain = new HashMap<>();
    for (int i = 0; i < 2_000; i++) {
      int detected = random.nextInt(1 + random.nextInt(1 + random.nextInt(TARGETS)));
      int state = values.state(7, random.nextInt(LEVELS), detected);
      double[] row = plain.computeIfAbsent(state, unseen -> new double[] {-1, -1, -1, -1, -1});
      assertRow(values, state, row, ties);
      int action = random.nextInt(LEVELS);
      row[action] = random.nextInt(-3, 2);
      values.set(7, state, action, row[action]);
      assertRow(values, state, row, ties);
    }
    plain.forEach((state, row) -> assertRow(values, state, row, ties));
  }

  @Test
  void aTableHasRoomForEveryTargetAtOnce() {
    ActionValues values = new ActionValues(bigNetwork(), settings(StateReading.LEVEL_COUNT));
    int last = values.state(0, LEVELS - 1, TARGETS);
    values.set(0, last, LEVELS - 1, 3);
    assertEquals(3, values.value(0, last, LEVELS - 1));
    assertEquals(0, values.value(0, last - 1, LEVELS - 1));
  }

  @Test
  void aTableGrowsForItsOwnCameraAlone() {
    ActionValues values = new ActionValues(bigNetwork(), settings(StateReading.LEVEL_COUNT));
    int state = values.state(0, 1, 3_000);
    values.set(0, state, 2, 3);
    assertEquals(0, values.value(1, state, 2));
    assertEquals(2, values.best(0, state));
    assertEquals(LEVELS - 1, values.best(1, state));
  }

  @Test
  void statesThatATableLacksAnswerLikeThoseItHasBeforeAnyUpdate() {
    for (Ties ties : Ties.values()) {
      ActionValues values =
          new ActionValues(bigNetwork(), settings(StateReading.LEVEL_COUNT, 2, ties));
      for (int levels = 1; levels <= LEVELS + 1; levels++) {
        int expected = ties == Ties.NARROWEST ? 0 : Math.min(levels, LEVELS) - 1;
        assertEquals(expected, values.answer(0, 0, 0, levels));
        assertEquals(expected, values.answer(0, 0, TARGETS, levels));
      }
    }
  }

  @Test
  void answersOfTheLevelsThatBothCamerasHave() {
    ActionValues values =
        new ActionValues(new ToyNetwork(1, 4, 2), settings(StateReading.LEVEL_COUNT));
    int state = values.state(0, 1, 1);
    values.set(0, state, 0, 1);
    values.set(0, state, 3, 2);
    assertEquals(3, values.answer(0, 1, 1, 4));
    assertEquals(0, values.answer(0, 1, 1, 3));
    assertEquals(1, values.answer(1, 1, 1, 4));
  }

  @Test
  void knowsTheLevelsOfItsCameraOrAllWhereLevelsDoNotCount() {
    ToyNetwork network = new ToyNetwork(1, 4, 2);
    ActionValues byLevel = new ActionValues(network, settings(StateReading.LEVEL_COUNT));
    assertTrue(byLevel.knows(1, 1));
    assertFalse(byLevel.knows(1, 2));
    assertTrue(new ActionValues(network, settings(StateReading.COUNT)).knows(1, 3));
    assertTrue(new ActionValues(network, settings(StateReading.NONE)).knows(1, 3));
  }

  @Test
  void theLargestTableThatFitsIsTaken() {
    TemporalDifferenceSettings settings = settings(StateReading.LEVEL_COUNT);
    int counts = (1 << 28) / (100 * 101); // rows of 101 entries, 100 rows a count
    ActionValues values = new ActionValues(new ToyNetwork(counts - 1, 100), settings);
    assertEquals(99, values.best(0, values.state(0, 99, counts - 1)));
    ToyNetwork larger = new ToyNetwork(counts, 100);
    InputException refused =
        assertThrows(InputException.class, () -> new ActionValues(larger, settings));
    assertEquals(
        "a camera's table of action values needs more than 268435456 entries for 26577 targets."
            + " Maybe give the option state=none",
        refused.getMessage());
  }

  private static void assertRow(ActionValues values, int state, double[] row, Ties ties) {
    assertEquals(ties.best(row, 0, LEVELS), values.best(7, state), "state " + state);
    for (int action = 0; action < LEVELS; action++) {
      assertEquals(row[action], values.value(7, state, action), "state " + state);
    }
  }

  private static ToyNetwork bigNetwork() {
    int[] levels = new int[CAMERAS];
    Arrays.fill(levels, LEVELS);
    return new ToyNetwork(TARGETS, levels);
  }

  private static TemporalDifferenceSettings settings(StateReading reading) {
    return settings(reading, 0, Ties.WIDEST);
  }

  private static TemporalDifferenceSettings settings(StateReading reading, double q0, Ties ties) {
    return new TemporalDifferenceSettings(
        reading, RewardReading.COUNT_CHANGE, 0.1, 0.9, 1, q0, ties);
  }
}
