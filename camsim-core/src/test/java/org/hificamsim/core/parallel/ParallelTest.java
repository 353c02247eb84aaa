package org.hificamsim.core.parallel;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertThrows;
import static org.junit.jupiter.api.Assertions.assertTimeoutPreemptively;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.time.Duration;
import java.util.List;
import java.util.Set;
import java.util.concurrent.ConcurrentHashMap;
import java.util.concurrent.CountDownLatch;
import java.util.stream.IntStream;
import org.junit.jupiter.api.Test;

class ParallelTest {
  @Test
  void resultsAreInTheOrderOfTheItems() {
    List<Integer> items = IntStream.range(0, 1000).boxed().toList();
    assertEquals(
        items.stream().map(item -> 2 * item).toList(), Parallel.map(items, 3, item -> 2 * item));
  }

  @Test
  void aFailureIsThrownWhileEarlierItemsAreStillAtWork() {
    CountDownLatch never = new CountDownLatch(1);
    CountDownLatch first = new CountDownLatch(1);
    Set<Integer> begun = ConcurrentHashMap.newKeySet();
    IllegalStateException thrown =
        assertTimeoutPreemptively(
            Duration.ofSeconds(60),
            () ->
                assertThrows(
                    IllegalStateException.class,
                    () ->
                        Parallel.map(
                            List.of(0, 1, 2, 3, 4),
                            2,
                            item -> {
                              begun.add(item);
                              if (item == 1) {
                                await(first);
                                throw new IllegalStateException("item 1");
                              }
                              first.countDown();
                              await(never);
                              return item;
                            })));
    assertEquals("item 1", thrown.getMessage());
    assertTrue(Set.of(0, 1, 2).containsAll(begun), begun::toString);
  }

  private static void await(CountDownLatch latch) {
    try {
      latch.await();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt(); // as the pool asks of work that it drops
    }
  }
}
