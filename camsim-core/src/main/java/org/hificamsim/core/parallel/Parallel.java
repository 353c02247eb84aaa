package org.hificamsim.core.parallel;

import java.io.InterruptedIOException;
import java.io.UncheckedIOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.CompletionService;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorCompletionService;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import java.util.function.Function;

/** Runs the same work on every item of a list, on a bounded number of threads. */
public final class Parallel {
  private Parallel() {}

  /**
   * The results in the order of the items. After a failure no further item begins; the first one is
   * thrown when those at work are done, so that nothing they use is taken from them.
   *
   * @param threads 1 or more
   */
  public static <T, R> List<R> map(List<T> items, int threads, Function<T, R> work) {
    ExecutorService pool = Executors.newFixedThreadPool(threads, Parallel::daemon);
    try {
      CompletionService<R> service = new ExecutorCompletionService<>(pool);
      List<Future<R>> futures = new ArrayList<>();
      for (T item : items) {
        futures.add(service.submit(() -> work.apply(item)));
      }
      await(service, futures);
      List<R> results = new ArrayList<>();
      for (Future<R> future : futures) {
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

  /** Waits for all, in the order in which they end; the first failure drops what has not begun. */
  private static <R> void await(CompletionService<R> service, List<Future<R>> futures)
      throws InterruptedException, ExecutionException {
    ExecutionException first = null;
    for (int i = 0; i < futures.size(); i++) {
      Future<R> ended = service.take();
      try {
        if (!ended.isCancelled()) {
          ended.get();
        }
      } catch (ExecutionException e) {
        first = first == null ? e : first;
        futures.forEach(future -> future.cancel(false));
      }
    }
    if (first != null) {
      throw first;
    }
  }

  private static RuntimeException thrown(Throwable cause) {
    if (cause instanceof Error fault) {
      throw fault;
    }
    return cause instanceof RuntimeException fault ? fault : new IllegalStateException(cause);
  }

  private static Thread daemon(Runnable work) {
    Thread thread = new Thread(work, "parallel");
    thread.setDaemon(true);
    return thread;
  }
}
