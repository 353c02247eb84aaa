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
   * The fewest bytes of some rounds. The JVM itself allocates now and then on the working thread,
   * as when it discards compiled code, at moments that depend on the machine's load; what the work
   * allocates is in every round.
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
