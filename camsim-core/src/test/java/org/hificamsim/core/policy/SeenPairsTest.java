package org.hificamsim.core.policy;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.SplittableRandom;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Test;

class SeenPairsTest {
  private record Pair(int camera, int target, double ahead, double right) {
    private double squared() {
      return ahead * ahead + right * right;
    }
  }

  private static final Comparator<Pair> NEAREST =
      Comparator.comparingInt(Pair::camera)
          .thenComparingDouble(Pair::squared)
          .thenComparingInt(Pair::target);

  /** Few coordinates, so that many targets are equally near. */
  @RepeatedTest(30)
  void sortsNearestTargetsOfEachCameraFirst(RepetitionInfo repetition) {
    SplittableRandom random = new SplittableRandom(repetition.getCurrentRepetition());
    SeenPairs pairs = new SeenPairs();
    for (int round = 0; round < 3; round++) {
      List<Pair> expected = new ArrayList<>();
      pairs.clear();
      for (int camera = 0; camera < 9; camera++) {
        for (int i = random.nextInt(8); i > 0; i--) {
          Pair expectedPair = new Pair(camera, i, random.nextInt(-3, 3), random.nextInt(3));
          pairs.add(camera, i, expectedPair.ahead, expectedPair.right);
          expected.add(expectedPair);
        }
      }
      expected.sort(NEAREST);
      pairs.sort(2);
      assertEquals(nearest(expected, 2), nearest(copy(pairs), 2));
      pairs.sort(8);
      assertEquals(expected, copy(pairs));
    }
  }

  /** Returns the first pairs of each camera. */
  private static List<Pair> nearest(List<Pair> pairs, int wanted) {
    int[] shown = new int[9];
    return pairs.stream().filter(pair -> shown[pair.camera]++ < wanted).toList();
  }

  private static List<Pair> copy(SeenPairs pairs) {
    List<Pair> copies = new ArrayList<>();
    for (int i = 0; i < pairs.count(); i++) {
      copies.add(new Pair(pairs.camera(i), pairs.target(i), pairs.ahead(i), pairs.right(i)));
    }
    return copies;
  }

  @Test
  void scratchKeepsValuesWhenItGrows() {
    SeenPairs pairs = new SeenPairs();
    pairs.scratch(3)[2] = 7;
    assertEquals(7, pairs.scratch(100)[2]);
    assertEquals(7, pairs.scratch(0)[2]);
  }
}
