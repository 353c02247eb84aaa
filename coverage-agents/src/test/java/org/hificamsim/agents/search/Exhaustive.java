package org.hificamsim.agents.search;

import java.util.Arrays;
import java.util.stream.Collectors;

/** The reference that tries every configuration, in the order of preference. */
record Exhaustive(int value, int[] choice) {
  /** The first best choice for sets of up to 64 targets. */
  static Exhaustive solve(int targets, long[][] sets) {
    int[] choice = new int[sets.length];
    int[] best = choice.clone();
    int most = -1;
    do {
      int value = value(targets, sets, choice);
      if (value > most) {
        most = value;
        best = choice.clone();
      }
    } while (next(choice, camera -> sets[camera].length));
    return new Exhaustive(most, best);
  }

  /** The best value for any number of targets. */
  static int value(int targets, boolean[][][] sets) {
    int[] choice = new int[sets.length];
    int most = 0;
    do {
      int least = sets.length;
      for (int target = 0; target < targets; target++) {
        int covered = 0;
        for (int camera = 0; camera < sets.length; camera++) {
          covered += sets[camera][choice[camera]][target] ? 1 : 0;
        }
        least = Math.min(least, covered);
      }
      most = Math.max(most, least);
    } while (next(choice, camera -> sets[camera].length));
    return most;
  }

  static String text(long[][] sets) {
    return Arrays.stream(sets)
        .map(
            camera ->
                Arrays.stream(camera).mapToObj(Long::toBinaryString).collect(Collectors.toList()))
        .toList()
        .toString();
  }

  /** Counts up with the last camera fastest, so that the first best is the most preferred. */
  static boolean next(int[] choice, java.util.function.IntUnaryOperator count) {
    for (int camera = choice.length - 1; camera >= 0; camera--) {
      if (++choice[camera] < count.applyAsInt(camera)) {
        return true;
      }
      choice[camera] = 0;
    }
    return false;
  }

  /** The value of one choice. */
  static int value(int targets, long[][] sets, int[] choice) {
    int least = sets.length;
    for (int target = 0; target < targets; target++) {
      int covered = 0;
      for (int camera = 0; camera < sets.length; camera++) {
        covered += (int) (sets[camera][choice[camera]] >>> target & 1);
      }
      least = Math.min(least, covered);
    }
    return least;
  }
}
