package org.hificamsim.network.study;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import java.util.stream.IntStream;
import org.junit.jupiter.api.RepeatedTest;
import org.junit.jupiter.api.RepetitionInfo;
import org.junit.jupiter.api.Test;
import org.locationtech.jts.geom.Envelope;
import org.locationtech.jts.geom.Geometry;
import org.locationtech.jts.geom.GeometryFactory;
import org.locationtech.jts.operation.union.CascadedPolygonUnion;

class FrontTest {
  /** Returns whole numbers, so that many points are equal or have one value in common. */
  private static double[] numbers(Random random, int count) {
    return random.ints(count, 0, 12).asDoubleStream().toArray();
  }

  @RepeatedTest(50)
  void containsAllUnbeatenPoints(RepetitionInfo repetition) {
    Random random = new Random(repetition.getCurrentRepetition());
    double[] utility = numbers(random, 30);
    double[] cost = numbers(random, 30);
    int[] all = IntStream.range(0, 30).toArray();
    int[] expected = IntStream.of(all).filter(i -> !isBeaten(i, utility, cost)).toArray();
    assertArrayEquals(expected, IntStream.of(Front.find(utility, cost, all)).sorted().toArray());
  }

  private static boolean isBeaten(int i, double[] utility, double[] cost) {
    return IntStream.range(0, utility.length)
        .anyMatch(
            j ->
                utility[j] >= utility[i]
                    && cost[j] <= cost[i]
                    && (utility[j] > utility[i] || cost[j] < cost[i]));
  }

  @RepeatedTest(20)
  void hypervolumeEqualsAreaComputedByJts(RepetitionInfo repetition) {
    Random random = new Random(repetition.getCurrentRepetition());
    double[] utility = random.doubles(15, 0, 5).toArray();
    double[] cost = random.doubles(15, 0, 70).toArray();
    GeometryFactory factory = new GeometryFactory();
    List<Geometry> beaten = new ArrayList<>();
    for (int i = 0; i < utility.length; i++) {
      beaten.add(factory.toGeometry(new Envelope(cost[i], 70, 0, utility[i])));
    }
    double area = CascadedPolygonUnion.union(beaten).getArea() / (5 * 70);
    int[] all = IntStream.range(0, 15).toArray();
    assertEquals(area, Front.hypervolume(utility, cost, all, 5, 70), 1e-9);
  }

  @Test
  void hypervolumeIsZeroWithoutUtilityOrCost() {
    assertEquals(0, Front.hypervolume(new double[] {0}, new double[] {3}, new int[] {0}, 0, 3));
    assertEquals(0, Front.hypervolume(new double[] {2}, new double[] {0}, new int[] {0}, 2, 0));
  }
}
