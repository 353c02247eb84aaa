package org.hificamsim.worlds;

import static org.junit.jupiter.api.Assertions.assertArrayEquals;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertSame;
import static org.junit.jupiter.api.Assertions.assertThrows;

import java.util.concurrent.atomic.AtomicIntegerArray;
import org.hificamsim.core.AllocatedBytes;
import org.junit.jupiter.api.Test;

class WorkersTest {
  @Test
  void everyWorkerDoesItsShareOnce() {
    try (Workers workers = Workers.of(4)) {
      AtomicIntegerArray shares = new AtomicIntegerArray(4);
      for (int round = 0; round < 1_000; round++) {
        workers.run(shares::incrementAndGet);
      }
      for (int worker = 0; worker < 4; worker++) {
        assertEquals(1_000, shares.get(worker));
      }
    }
  }

  @Test
  void callerSeesWritesOfWorkers() {
    try (Workers workers = Workers.of(3)) {
      int[] written = new int[300];
      for (int round = 1; round <= 2_000; round++) {
        int value = round;
        workers.run(
            worker -> {
              for (int i = workers.first(worker, 300); i < workers.first(worker + 1, 300); i++) {
                written[i] = value;
              }
            });
        for (int entry : written) {
          assertEquals(value, entry);
        }
      }
    }
  }

  @Test
  void sharesCoverAllItemsInOrder() {
    try (Workers workers = Workers.of(4)) {
      int[] firsts = {
        workers.first(0, 10),
        workers.first(1, 10),
        workers.first(2, 10),
        workers.first(3, 10),
        workers.first(4, 10)
      };
      assertArrayEquals(new int[] {0, 2, 5, 7, 10}, firsts);
      assertEquals(2_000_000_000, workers.first(4, 2_000_000_000));
    }
  }

  @Test
  void failedShareThrowsInCallerAndNextRoundRuns() {
    try (Workers workers = Workers.of(2)) {
      IllegalStateException thrown =
          assertThrows(
              IllegalStateException.class,
              () ->
                  workers.run(
                      worker -> {
                        if (worker == 1) {
                          throw new IllegalStateException("worker 1");
                        }
                      }));
      assertEquals("worker 1", thrown.getMessage());
      int[] done = new int[2];
      workers.run(worker -> done[worker] = 1);
      assertArrayEquals(new int[] {1, 1}, done);
    }
  }

  @Test
  void startingWorkAllocatesNothing() {
    try (Workers workers = Workers.of(2)) {
      int[] done = new int[2];
      Workers.Share share = worker -> done[worker]++;
      long bytes = AllocatedBytes.fewest(() -> AllocatedBytes.by(() -> rounds(workers, share)));
      assertEquals(0, bytes, "bytes in 2,000 rounds");
    }
  }

  @Test
  void singleWorkerIsThreadOfCaller() {
    assertSame(Workers.CALLER, Workers.of(1));
    Thread[] ran = new Thread[1];
    Workers.CALLER.run(worker -> ran[worker] = Thread.currentThread());
    assertSame(Thread.currentThread(), ran[0]);
  }

  private static void rounds(Workers workers, Workers.Share share) {
    for (int round = 0; round < 2_000; round++) {
      workers.run(share);
    }
  }

  @Test
  void closingEndsSleepingThreads() throws InterruptedException {
    Thread[] threads = new Thread[2];
    try (Workers workers = Workers.of(2)) {
      workers.run(worker -> threads[worker] = Thread.currentThread());
      while (threads[1].getState() != Thread.State.WAITING) {
        Thread.onSpinWait();
      }
    }
    threads[1].join(10_000);
    assertFalse(threads[1].isAlive());
  }
}
