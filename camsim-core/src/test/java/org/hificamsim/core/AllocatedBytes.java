package org.hificamsim.core;

import com.sun.management.ThreadMXBean;
import java.lang.management.ManagementFactory;
import java.util.function.LongSupplier;

/** Measures how much memory the calling thread allocates; work on other threads does not count. */
public final class AllocatedBytes {
  private static final ThreadMXBean THREADS = (ThreadMXBean) ManagementFactory.getThreadMXBean();
  private static final int ROUNDS = 10;

  private AllocatedBytes() {}

  /** Returns the bytes that one call of the work allocates. */
  public static long by(Runnable work) {
    long before = THREADS.getCurrentThreadAllocatedBytes();
    work.run();
    return THREADS.getCurrentThreadAllocatedBytes() - before;
  }

  /**
   * Returns the fewest bytes of several rounds. A single round may count bytes that the JVM itself
   * allocates (once 240 bytes for a policy that only copies an array). Allocations rarer than one
   * per round go unnoticed.
   *
   * @param round does the work and returns its bytes
   */
  public static long fewest(LongSupplier round) {
    long fewest = Long.MAX_VALUE;
    for (int i = 0; i < ROUNDS && fewest > 0; i++) {
      fewest = Math.min(fewest, round.getAsLong());
    }
    return fewest;
  }
}
