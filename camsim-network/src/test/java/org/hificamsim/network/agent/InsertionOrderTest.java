package org.hificamsim.network.agent;

import static org.junit.jupiter.api.Assertions.assertEquals;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.junit.jupiter.api.Test;

/** A set that is walked through in the order of insertion. */
class InsertionOrderTest {
  @Test
  void randomInsertionsAndRemovalsAgreeWithALinkedSet() {
    SplittableRandom random = new SplittableRandom(5);
    Set<Integer> expected = new LinkedHashSet<>();
    InsertionOrder order = new InsertionOrder(20);
    for (int i = 0; i < 3000; i++) {
      int number = random.nextInt(20);
      if (random.nextBoolean()) {
        order.add(number);
        expected.add(number);
      } else {
        order.remove(number);
        expected.remove(number);
      }
      assertEquals(new ArrayList<>(expected), members(order));
      assertEquals(expected.size(), order.size());
      assertEquals(expected.contains(7), order.contains(7));
    }
  }

  private static List<Integer> members(InsertionOrder order) {
    List<Integer> members = new ArrayList<>();
    for (int n = order.first(); n != InsertionOrder.END; n = order.next(n)) {
      members.add(n);
    }
    return members;
  }
}
