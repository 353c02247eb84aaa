package org.hificamsim.network.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;

/** The order in which a Java hash map iterates. */
class HashOrderTest {
  @ParameterizedTest
  @CsvSource({
    "1.0, 1072693279", "2.0, 1073741855", "3.0, 1074266143", "4.0, 1074790431",
    "3.996, -1726385916", "4.107, 677567951", "4.44, 473511787", "4.884, 198520550",
  })
  void hashCodesOfFeaturesAreTheKnownOnes(double features, int hash) {
    assertEquals(hash, HashOrder.hashOfFeatures(features));
  }

  @Test
  void itemsOfOneBucketStayInTheOrderOfInsertion() {
    HashOrder order = new HashOrder();
    double[] features = {4.0, 2.0, 3.0, 1.0};
    for (int item = 0; item < features.length; item++) {
      order.add(item, HashOrder.hashOfFeatures(features[item]));
    }
    assertEquals(List.of(2, 0, 1, 3), items(order));
  }

  @Test
  void randomInsertionsAndRemovalsAgreeWithAHashMap() {
    SplittableRandom random = new SplittableRandom(3);
    Map<List<Double>, Integer> map = new HashMap<>();
    HashOrder order = new HashOrder();
    double[] features = random.doubles(60, 0, 10).toArray();
    for (int i = 0; i < 5000; i++) {
      int item = random.nextInt(features.length);
      int place = items(order).indexOf(item);
      if (place >= 0) {
        order.removeAt(place);
        map.remove(List.of(features[item]));
      } else if (random.nextInt(60) >= order.size()) {
        order.add(item, HashOrder.hashOfFeatures(features[item]));
        map.put(List.of(features[item]), item);
      }
      assertEquals(new ArrayList<>(map.values()), items(order));
    }
  }

  @Test
  void aCopyIsFilledFromTheFirstCapacityOn() {
    HashOrder grown = new HashOrder();
    Map<List<Double>, Integer> copied = new HashMap<>();
    for (int item = 0; item < 13; item++) {
      grown.add(item, HashOrder.hashOfFeatures(item + 0.5));
    }
    while (grown.size() > 5) {
      grown.removeAt(grown.size() / 2);
    }
    HashOrder copy = new HashOrder();
    copy.copy(grown);
    items(grown).forEach(item -> copied.put(List.of(item + 0.5), item));
    assertEquals(new ArrayList<>(copied.values()), items(copy));
  }

  private static List<Integer> items(HashOrder order) {
    List<Integer> items = new ArrayList<>();
    for (int i = 0; i < order.size(); i++) {
      items.add(order.get(i));
    }
    return items;
  }
}
