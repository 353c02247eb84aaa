package org.hificamsim.worlds;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.AllocatedBytes;
import org.hificamsim.core.InputException;
import org.hificamsim.core.engine.RunCoverage;
import org.hificamsim.core.engine.Simulation;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.world.World;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

class WorldsTest {
  private static final int STEPS = 120;

  private static WorldSettings settings(String scenario, int steps) {
    return Played.settings(scenario, "coverage", ActionKind.VIEW, steps, true);
  }

  /** The campus has lenses, walls, targets that come and go, and a camera that fails. */
  @ParameterizedTest
  @ValueSource(strings = {"cluster-random", "campus", "mate-4v8-9"})
  void worldDependsOnSeedAndActionsOnly(String scenario) {
    try (Played many = new Played(settings(scenario, 50), 5, 3, 7)) {
      List<List<Integer>> hashes = new ArrayList<>();
      for (int step = 0; step < STEPS; step++) {
        many.step(7);
        hashes.add(List.of(many.hash(0), many.hash(1), many.hash(4)));
      }
      int[] numbers = {0, 1, 4};
      for (int i = 0; i < numbers.length; i++) {
        try (Played one = new Played(settings(scenario, 50), 1, 1, 7 + numbers[i])) {
          for (int step = 0; step < STEPS; step++) {
            one.step(7 + numbers[i]);
            assertEquals(
                hashes.get(step).get(i), one.hash(0), "world " + numbers[i] + " at " + step);
          }
        }
      }
      assertEquals(STEPS, hashes.stream().distinct().count(), "every step is different");
    }
  }

  @ParameterizedTest
  @ValueSource(strings = {"cluster-random", "campus"})
  void resetWithSameSeedRepeatsEpisode(String scenario) {
    try (Played played = new Played(settings(scenario, 50), 2, 1, 3);
        Played fresh = new Played(settings(scenario, 50), 2, 1, 3)) {
      for (int step = 0; step < STEPS; step++) {
        played.step(3);
      }
      played.worlds().reset(3, true);
      for (int step = 0; step < 60; step++) {
        played.stepAll(step % 3);
        fresh.stepAll(step % 3);
        for (String part : List.of("observations", "rewards", "masks", "ends")) {
          assertArrayEquals(fresh.bytes(part, 1), played.bytes(part, 1), part + " at " + step);
        }
      }
    }
  }

  @Test
  void nextEpisodeDiffers() {
    try (Played played = new Played(settings("cluster-random", 200), 1, 1, 3)) {
      List<float[]> first = episode(played, 200);
      List<float[]> second = episode(played, 200);
      assertArrayEquals(first.get(0), second.get(0), "targets begin where the file puts them");
      assertFalse(Arrays.equals(first.get(50), second.get(50)));
    }
  }

  private static List<float[]> episode(Played played, int steps) {
    List<float[]> all = new ArrayList<>();
    for (int step = 0; step < steps; step++) {
      all.add(played.floats("observations", 0));
      played.stepAll(4);
    }
    return all;
  }

  /** The run of a policy is played again by its recorded views. */
  @ParameterizedTest
  @ValueSource(strings = {"cluster-random", "campus"})
  void firstEpisodeEqualsRunOfItsSeed(String scenario) {
    WorldSettings settings = settings(scenario, STEPS + 1);
    List<int[]> views = new ArrayList<>();
    List<Integer> kMin = new ArrayList<>();
    RunCoverage coverage = new RunCoverage();
    StepListener recorder =
        (network, measured) -> {
          int[] now = new int[network.cameras()];
          Arrays.setAll(now, network::view);
          views.add(now);
          kMin.add(measured.kMin());
        };
    new Simulation(
            new World(settings.scenario(), settings.movements(), 5),
            settings.detection(),
            Played.CATALOGUE.policies().create("random"),
            5,
            List.of(recorder, coverage))
        .run(STEPS);
    try (Played played = new Played(settings, 1, 1, 5)) {
      double uncovered = 0;
      for (int step = 0; step < STEPS; step++) {
        played.stepAll(views.get(step));
        assertEquals(kMin.get(step).floatValue(), played.floats("measures", 0)[1]);
        uncovered += 1 - played.floats("measures", 0)[0];
      }
      assertTrue(uncovered > 0 && uncovered < STEPS);
      assertEquals(STEPS, coverage.steps());
    }
  }

  @Test
  void autoResetKeepsFinalObservation() {
    try (Played auto = new Played(settings("cluster-random", 10), 2, 1, 1);
        Played longer = new Played(settings("cluster-random", 11), 2, 1, 1)) {
      float[] first = auto.floats("observations", 1);
      for (int step = 0; step < 10; step++) {
        assertEquals(0, auto.bytes("ends", 1)[0]);
        auto.stepAll(1);
        longer.stepAll(1);
      }
      assertEquals(1, auto.bytes("ends", 1)[0]);
      assertArrayEquals(longer.floats("observations", 1), auto.floats("finals", 1));
      assertFalse(Arrays.equals(auto.floats("finals", 1), auto.floats("observations", 1)));
      assertEquals(first.length, auto.floats("observations", 1).length);
    }
  }

  @Test
  void episodeEndsWithoutAutoReset() {
    WorldSettings settings =
        Played.settings("cluster-random", "coverage", ActionKind.VIEW, 2, false);
    try (Played played = new Played(settings, 1, 1, 1)) {
      played.stepAll(0);
      played.stepAll(0);
      String line = assertThrows(EpisodeOverException.class, () -> played.stepAll(0)).getMessage();
      assertEquals("the episode of 2 steps is over, expected a reset", line);
      played.worlds().reset(0, false);
      played.stepAll(0);
    }
  }

  @Test
  void rejectsInvalidActionBeforeMovingAnything() {
    try (Played played = new Played(settings("cluster-random", 10), 2, 2, 1)) {
      int before = played.hash(0);
      String line = assertThrows(InputException.class, () -> played.stepAll(0, 0, 5)).getMessage();
      assertEquals("action 5 of camera Cam_03 in world 0, expected 0 to 4", line);
      played.part("actions").put(new byte[played.part("actions").capacity()]);
      assertEquals(before, played.hash(0));
    }
  }

  @Test
  void stepsAllocateNothing() {
    WorldSettings settings = settings("mate-4v8-9", 1_000_000);
    try (Played played = new Played(settings, 3, 1, 1)) {
      Worlds worlds = played.worlds();
      Runnable round =
          () -> {
            for (int step = 0; step < 5_000; step++) {
              worlds.step();
            }
          };
      round.run();
      assertEquals(0, AllocatedBytes.fewest(() -> AllocatedBytes.by(round)));
    }
  }

  @Test
  void stateHasTimeCamerasAndTargets() {
    try (Played played = new Played(settings("cluster-random", 10), 1, 1, 1)) {
      played.stepAll(4);
      played.worlds().writeStates();
      float[] state = played.floats("states", 0);
      assertEquals(0.1f, state[0]);
      assertEquals(1, state[1], "the first camera is on");
      int target = 1 + 14 * 14;
      int targets = (state.length - target) / 4;
      for (int i = 0; i < targets; i++) {
        assertEquals(1, state[target + 4 * i], "target " + i + " is there");
        assertTrue(state[target + 4 * i + 1] > 0 && state[target + 4 * i + 1] < 1);
      }
      assertEquals(Played.scenario("cluster-random").targets().size(), targets);
    }
  }
}
