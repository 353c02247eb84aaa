package org.hificamsim.core.parallel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.List;
import java.util.concurrent.atomic.AtomicInteger;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ParallelTest {
  @Test
  void returnsResultsInOrderOfItems() {
    List<Integer> items = IntStream.range(0, 1000).boxed().toList();
    assertEquals(
        items.stream().map(item -> 2 * item).toList(), Parallel.map(items, 3, item -> 2 * item));
  }

  @Test
  void failureStopsNewItemsAndAwaitsRunningOnes() {
    List<Integer> items = IntStream.range(0, 20_000).boxed().toList();
    AtomicInteger begun = new AtomicInteger();
    AtomicInteger ended = new AtomicInteger();
    IllegalStateException thrown =
        assertThrows(
            IllegalStateException.class,
            () ->
                Parallel.map(
                    items,
                    2,
                    item -> {
                      begun.incrementAndGet();
                      pause(item == 0 ? 50 : 1);
                      ended.incrementAndGet();
                      if (item == 1) {
                        throw new IllegalStateException("item 1");
                      }
                      return item;
                    }));
    assertEquals("item 1", thrown.getMessage());
    assertEquals(begun.get(), ended.get());
    assertTrue(begun.get() < items.size(), begun::toString);
  }

  private static void pause(int milliseconds) {
    try {
      Thread.sleep(milliseconds);
    } catch (InterruptedException e) {
      throw new IllegalStateException(e);
    }
  }
}
