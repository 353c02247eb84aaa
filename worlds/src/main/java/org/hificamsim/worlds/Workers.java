package org.hificamsim.worlds;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;

/**
 * Threads that share the work of a step: the caller's and as many more as were asked for, which
 * live until {@link #close}. Handing work over allocates nothing.
 *
 * <p>One run uses them at a time. A worker waits for work awake for a moment, then asleep.
 */
public final class Workers implements AutoCloseable {
  /** The caller's thread alone. */
  public static final Workers CALLER = new Workers(1);

  /** How often a worker looks for work before it falls asleep: some tens of microseconds. */
  private static final int LOOKS = 2_000;

  /** A share of some work. */
  @FunctionalInterface
  public interface Share {
    /**
     * Does one worker's share.
     *
     * @param worker in [0, {@link #count})
     */
    void run(int worker);
  }

  private final Thread[] threads;
  private final AtomicInteger round = new AtomicInteger();
  private final AtomicInteger atWork = new AtomicInteger();
  private final AtomicReference<Throwable> failure = new AtomicReference<>();
  private Share share;
  private volatile Thread caller;
  private volatile boolean closed;

  private Workers(int count) {
    threads = new Thread[count - 1];
    for (int i = 0; i < threads.length; i++) {
      int worker = i + 1;
      threads[i] = new Thread(() -> work(worker), "worker-" + worker);
      threads[i].setDaemon(true);
      threads[i].start();
    }
  }

  /**
   * That many workers.
   *
   * @param count 1 or more, the caller included
   */
  public static Workers of(int count) {
    return count == 1 ? CALLER : new Workers(count);
  }

  /** The number of workers, the caller included. */
  public int count() {
    return threads.length + 1;
  }

  /** The first of {@code all} items that belong to a worker; its last is before the next one's. */
  public int first(int worker, int all) {
    return threads.length == 0 ? all * worker : (int) ((long) all * worker / count());
  }

  /**
   * Has every worker do its share, and waits for all.
   *
   * @throws RuntimeException what a share threw
   */
  public void run(Share newShare) {
    if (threads.length == 0) {
      newShare.run(0);
      return;
    }
    share = newShare;
    caller = Thread.currentThread();
    atWork.set(threads.length);
    round.incrementAndGet();
    for (Thread thread : threads) {
      LockSupport.unpark(thread);
    }
    attempt(0);
    for (int look = 0; atWork.get() > 0; look++) {
      pause(look);
    }
    rethrow();
  }

  private void work(int worker) {
    int done = 0;
    while (true) {
      for (int look = 0; round.get() == done && !closed; look++) {
        pause(look);
      }
      if (closed) {
        return;
      }
      done = round.get();
      attempt(worker);
      if (atWork.decrementAndGet() == 0) {
        LockSupport.unpark(caller);
      }
    }
  }

  private void attempt(int worker) {
    try {
      share.run(worker);
    } catch (RuntimeException | Error e) {
      failure.compareAndSet(null, e);
    }
  }

  private void pause(int look) {
    if (look < LOOKS) {
      Thread.onSpinWait();
    } else {
      LockSupport.park(this);
    }
  }

  private void rethrow() {
    Throwable thrown = failure.getAndSet(null);
    if (thrown instanceof Error error) {
      throw error;
    } else if (thrown instanceof RuntimeException exception) {
      throw exception;
    }
  }

  /** Ends the threads. */
  @Override
  public void close() {
    closed = true;
    for (Thread thread : threads) {
      LockSupport.unpark(thread);
    }
  }
}
