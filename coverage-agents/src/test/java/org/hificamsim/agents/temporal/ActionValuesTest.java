package org.hificamsim.agents.temporal;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.lang.reflect.Proxy;
import java.util.Arrays;
import java.util.HashMap;
import java.util.Iterator;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.Stream;
import net.jqwik.api.ForAll;
import net.jqwik.api.Property;
import net.jqwik.api.constraints.IntRange;
import org.hificamsim.agents.choice.Ties;
import org.hificamsim.agents.toy.ToyNetwork;
import org.hificamsim.core.AllocatedBytes;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.NetworkView;
import org.junit.jupiter.api.Test;

class ActionValuesTest {
  /** The number of cameras with which tables do not have all states at first. */
  private static final int CAMERAS = 200;

  private static final int VIEWS = 5;
  private static final int TARGETS = 4_000;

  @Property(tries = 200)
  void findsTheBestActionAfterRandomUpdates(
      @ForAll @IntRange(min = 1, max = 6) int views, @ForAll Ties ties, @ForAll long seed) {
    ActionValues values = new ActionValues(new ToyNetwork(2, views), StateReading.COUNT, ties, 0);
    SplittableRandom random = new SplittableRandom(seed);
    double[] expected = new double[views];
    for (int i = 0; i < 100; i++) {
      int action = random.nextInt(views);
      expected[action] = random.nextInt(-3, 4); // few different values, so that many are equal
      values.set(0, 1, action, expected[action]);
      assertEquals(ties.best(expected, 0, views), values.best(0, 1), "update " + i);
    }
  }

  @Property(tries = 20)
  void growingTablesHoldTheSameAsCompleteOnes(
      @ForAll StateReading reading, @ForAll Ties ties, @ForAll long seed) {
    ActionValues values = new ActionValues(bigNetwork(), reading, ties, -1);
    SplittableRandom random = new SplittableRandom(seed);
    Map<Integer, double[]> expected = new HashMap<>();
    for (int i = 0; i < 2_000; i++) {
      int percept = random.nextInt(1 + random.nextInt(1 + random.nextInt(TARGETS)));
      int state = values.state(7, random.nextInt(VIEWS), percept % reading.percepts(TARGETS));
      double[] row = expected.computeIfAbsent(state, newState -> new double[] {-1, -1, -1, -1, -1});
      assertRow(values, state, row, ties);
      int action = random.nextInt(VIEWS);
      row[action] = random.nextInt(-3, 2);
      values.set(7, state, action, row[action]);
      assertRow(values, state, row, ties);
    }
    expected.forEach((state, row) -> assertRow(values, state, row, ties));
  }

  @Test
  void tableCoversDetectionsOfAllTargets() {
    ActionValues values = new ActionValues(bigNetwork(), StateReading.LEVEL_COUNT, Ties.WIDEST, 0);
    int last = values.state(0, VIEWS - 1, TARGETS);
    values.set(0, last, VIEWS - 1, 3);
    assertEquals(3, values.value(0, last, VIEWS - 1));
    assertEquals(0, values.value(0, last - 1, VIEWS - 1));
  }

  @Test
  void tableGrowsForOneCameraOnly() {
    ActionValues values = new ActionValues(bigNetwork(), StateReading.LEVEL_COUNT, Ties.WIDEST, 0);
    int state = values.state(0, 1, 3_000);
    values.set(0, state, 2, 3);
    assertEquals(0, values.value(1, state, 2));
    assertEquals(2, values.best(0, state));
    assertEquals(VIEWS - 1, values.best(1, state));
  }

  @Test
  void missingStatesHaveInitialValues() {
    for (Ties ties : Ties.values()) {
      ActionValues values = new ActionValues(bigNetwork(), StateReading.COUNT, ties, 2);
      for (int detected = 0; detected < 10; detected++) {
        assertEquals(2, values.value(0, detected, 0));
        assertEquals(ties.best(VIEWS), values.best(0, detected));
      }
    }
  }

  @Test
  void tableGrowsByOneState() {
    for (StateReading reading : StateReading.values()) {
      ActionValues values = new ActionValues(bigNetwork(), reading, Ties.WIDEST, 0);
      for (int percept = 0; percept <= 40 && percept < reading.percepts(TARGETS); percept++) {
        for (int view = 0; view < VIEWS; view++) {
          int state = values.state(0, view, percept);
          values.set(0, state, 1, 3);
          assertEquals(1, values.best(0, state));
        }
      }
    }
  }

  @Test
  void updatesOfSmallNetworksAllocateNothing() {
    Iterator<ActionValues> newTables =
        Stream.generate(
                () ->
                    new ActionValues(
                        new ToyNetwork(50, 5), StateReading.LEVEL_COUNT, Ties.WIDEST, 0))
            .iterator();
    assertEquals(
        0,
        AllocatedBytes.fewest(
            () -> {
              ActionValues values = newTables.next();
              return AllocatedBytes.by(() -> values.set(0, values.state(0, 4, 50), 0, 1));
            }));
  }

  @Test
  void acceptsLargestTableThatFits() {
    int counts = (1 << 28) / 128; // a row has an entry for each of 127 views, and one more
    ActionValues values =
        new ActionValues(oneCamera(127, counts - 1), StateReading.COUNT, Ties.WIDEST, 0);
    assertEquals(126, values.best(0, counts - 1));
    NetworkView larger = oneCamera(127, counts);
    InputException error =
        assertThrows(
            InputException.class,
            () -> new ActionValues(larger, StateReading.COUNT, Ties.WIDEST, 0));
    assertEquals(
        "a camera's table of action values needs more than 268435456 entries for 2097152 targets"
            + " and 127 views. Maybe give the option state=none",
        error.getMessage());
  }

  /** A network that knows only its size. */
  private static NetworkView oneCamera(int views, int targets) {
    return (NetworkView)
        Proxy.newProxyInstance(
            NetworkView.class.getClassLoader(),
            new Class<?>[] {NetworkView.class},
            (proxy, method, arguments) ->
                switch (method.getName()) {
                  case "cameras", "pans" -> 1;
                  case "viewAt" -> views - 1;
                  case "views", "zooms" -> views;
                  case "targets" -> targets;
                  default -> throw new UnsupportedOperationException(method.getName());
                });
  }

  private static void assertRow(ActionValues values, int state, double[] row, Ties ties) {
    assertEquals(ties.best(row, 0, VIEWS), values.best(7, state), "state " + state);
    for (int action = 0; action < VIEWS; action++) {
      assertEquals(row[action], values.value(7, state, action), "state " + state);
    }
  }

  private static ToyNetwork bigNetwork() {
    int[] views = new int[CAMERAS];
    Arrays.fill(views, VIEWS);
    return new ToyNetwork(TARGETS, views);
  }
}
