package org.hificamsim.worlds;

import java.util.concurrent.atomic.AtomicInteger;
import java.util.concurrent.atomic.AtomicReference;
import java.util.concurrent.locks.LockSupport;

/**
 * Threads that share the work of a step: the thread of the caller, and others that live until
 * {@link #close}. Starting work does not allocate.
 *
 * <p>Only one thread may call {@link #run} at a time. A worker spins for a short time while it
 * waits for work, then sleeps.
 */
final class Workers implements AutoCloseable {
  /** A single worker, the thread of the caller. */
  static final Workers CALLER = new Workers(1);

  /** The number of spins before a worker sleeps: some tens of microseconds. */
  private static final int SPINS = 2_000;

  /** Work that is divided among the workers. */
  @FunctionalInterface
  interface Share {
    /**
     * Does the share of a worker.
     *
     * @param worker the number of the worker, in [0, {@link #count})
     */
    void run(int worker);
  }

  private final Thread[] threads;
  private final AtomicInteger round = new AtomicInteger();
  private final AtomicInteger unfinishedWorkers = new AtomicInteger();
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
   * Returns a number of workers.
   *
   * @param count the number, 1 or more, including the caller
   */
  static Workers of(int count) {
    return count == 1 ? CALLER : new Workers(count);
  }

  /** The number of workers, including the caller. */
  int count() {
    return threads.length + 1;
  }

  /** The index of the first item of a worker; its items end before the first of the next worker. */
  int first(int worker, int items) {
    return (int) ((long) items * worker / count());
  }

  /**
   * Runs the share of every worker, and waits for all of them.
   *
   * @throws RuntimeException the exception of a share, if one failed
   */
  void run(Share newShare) {
    if (threads.length == 0) {
      newShare.run(0);
      return;
    }
    share = newShare;
    caller = Thread.currentThread();
    unfinishedWorkers.set(threads.length);
    round.incrementAndGet();
    for (Thread thread : threads) {
      LockSupport.unpark(thread);
    }
    attempt(0);
    for (int spins = 0; unfinishedWorkers.get() > 0; spins++) {
      pause(spins);
    }
    rethrow();
  }

  private void work(int worker) {
    int finishedRound = 0;
    while (true) {
      for (int spins = 0; round.get() == finishedRound && !closed; spins++) {
        pause(spins);
      }
      if (closed) {
        return;
      }
      finishedRound = round.get();
      attempt(worker);
      if (unfinishedWorkers.decrementAndGet() == 0) {
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

  private void pause(int spins) {
    if (spins < SPINS) {
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

  /** Stops the threads. */
  @Override
  public void close() {
    closed = true;
    for (Thread thread : threads) {
      LockSupport.unpark(thread);
    }
  }
}
