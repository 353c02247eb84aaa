package org.hificamsim.network.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** Compares the order with that in which a Java hash map iterates. */
class HashOrderTest {
  @ParameterizedTest
  @CsvSource({
    "1.0, 1072693279", "2.0, 1073741855", "3.0, 1074266143", "4.0, 1074790431",
    "3.996, -1726385916", "4.107, 677567951", "4.44, 473511787", "4.884, 198520550",
  })
  void hashesFeaturesLikeCamSim(double features, int hash) {
    assertEquals(hash, new TargetKeys(new double[] {features}).hash(0));
  }

  @Test
  void keepsInsertionOrderInOneBucket() {
    HashOrder order = new HashOrder();
    TargetKeys keys = new TargetKeys(new double[] {4.0, 2.0, 3.0, 1.0});
    IntStream.range(0, 4).forEach(target -> order.add(target, keys.hash(target)));
    assertEquals(List.of(2, 0, 1, 3), items(order));
  }

  @Test
  void followsHashMapThroughRandomChanges() {
    followsHashMap(new SplittableRandom(3).doubles(60, 0, 10).toArray());
  }

  @Test
  void growsLikeHashMapWhereOneBucketIsFull() {
    followsHashMap(IntStream.range(0, 12).mapToDouble(power -> 1 << power).toArray());
  }

  private static void followsHashMap(double[] features) {
    SplittableRandom random = new SplittableRandom(3);
    Map<List<Double>, Integer> map = new HashMap<>();
    HashOrder order = new HashOrder();
    TargetKeys keys = new TargetKeys(features);
    for (int i = 0; i < 5000; i++) {
      int target = random.nextInt(features.length);
      int index = items(order).indexOf(target);
      if (index >= 0) {
        order.removeAt(index);
        map.remove(List.of(features[target]));
      } else if (random.nextInt(features.length) >= order.size()) {
        order.add(target, keys.hash(target));
        map.put(List.of(features[target]), target);
      }
      assertEquals(new ArrayList<>(map.values()), items(order));
    }
  }

  @Test
  void fillsCopyFromFirstCapacity() {
    OwnedTargets owned =
        new OwnedTargets(
            new TargetKeys(IntStream.range(0, 13).mapToDouble(i -> i + 0.5).toArray()));
    IntStream.range(0, 13).forEach(owned::add);
    IntStream.range(0, 8).forEach(owned::remove);
    Map<List<Double>, Integer> copied = new HashMap<>();
    for (int i = 0; i < owned.count(); i++) {
      copied.put(List.of(owned.target(i) + 0.5), owned.target(i));
    }
    assertEquals(
        new ArrayList<>(copied.values()),
        IntStream.range(0, owned.count()).mapToObj(owned::targetOfCopy).toList());
  }

  private static List<Integer> items(HashOrder order) {
    return IntStream.range(0, order.size()).mapToObj(order::get).toList();
  }
}
