package org.hificamsim.core.parallel;

import java.io.InterruptedIOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.Callable;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.concurrent.ThreadFactory;
import java.util.concurrent.atomic.AtomicBoolean;
import java.util.function.Function;

/** Runs the same work on every item of a list, on a bounded number of threads. */
public final class Parallel {
  private Parallel() {}

  /**
   * Returns the results in the order of the items. After a failure no further item is started; the
   * failure of the first item is thrown once all running items have ended.
   *
   * @param threads 1 or more
   */
  public static <T, R> List<R> map(List<T> items, int threads, Function<T, R> work) {
    ExecutorService pool = Executors.newFixedThreadPool(threads, daemons("parallel"));
    AtomicBoolean failed = new AtomicBoolean();
    List<Callable<R>> tasks = new ArrayList<>();
    for (T item : items) {
      tasks.add(() -> failed.get() ? null : result(work, item, failed));
    }
    try {
      List<R> results = new ArrayList<>();
      for (Future<R> future : pool.invokeAll(tasks)) { // when all are done
        results.add(future.get());
      }
      return results;
    } catch (ExecutionException e) {
      throw thrown(e.getCause());
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new UncheckedIOException(new InterruptedIOException("interrupted"));
    } finally {
      pool.shutdownNow();
    }
  }

  private static <T, R> R result(Function<T, R> work, T item, AtomicBoolean failed) {
    try {
      return work.apply(item);
    } catch (RuntimeException | Error e) {
      failed.set(true);
      throw e;
    }
  }

  private static RuntimeException thrown(Throwable cause) {
    if (cause instanceof Error fault) {
      throw fault;
    }
    return cause instanceof RuntimeException fault ? fault : new IllegalStateException(cause);
  }

  /** Makes daemon threads of this name, which do not keep the program alive. */
  public static ThreadFactory daemons(String name) {
    return work -> {
      Thread thread = new Thread(work, name);
      thread.setDaemon(true);
      return thread;
    };
  }
}
