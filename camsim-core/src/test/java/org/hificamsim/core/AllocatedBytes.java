package org.hificamsim.core;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.function.LongSupplier;

/** How much memory the calling thread allocates. Work on other threads does not count. */
public final class AllocatedBytes {
  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
  private static final int ROUNDS = 10;

  private AllocatedBytes() {}

  /** The bytes that one call of the work takes. */
  public static long by(Runnable work) {
    long before = THREADS.getCurrentThreadAllocatedBytes();
    work.run();
    return THREADS.getCurrentThreadAllocatedBytes() - before;
  }

  /**
   * The fewest bytes of some rounds: what the work allocates in each. One round alone has once
   * counted 240 bytes of a policy that only copies an array, presumably the JVM's own; the price is
   * that work which allocates more rarely than once a round goes unnoticed.
   *
   * @param round works, and returns the bytes that count
   */
  public static long fewest(LongSupplier round) {
    long fewest = Long.MAX_VALUE;
    for (int i = 0; i < ROUNDS && fewest > 0; i++) {
      fewest = Math.min(fewest, round.getAsLong());
    }
    return fewest;
  }
}
