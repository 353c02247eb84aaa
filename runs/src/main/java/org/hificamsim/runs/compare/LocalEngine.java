package org.hificamsim.runs.compare;

import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.concurrent.ExecutionException;
import java.util.concurrent.ExecutorService;
import java.util.concurrent.Executors;
import java.util.concurrent.Future;
import org.hificamsim.core.InputException;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;

/** Computes runs on the threads of this machine. */
public final class LocalEngine implements RunEngine {
  /** The name of the engine that is used by default. */
  public static final String NAME = "local";

  private RunExecutor executor;
  private int threads;

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public void configure(EngineSettings settings) {
    settings
        .master()
        .ifPresent(
            master -> {
              throw new InputException(
                  "--master '" + master + "' is of no use to --engine local, expected none");
            });
    executor = new RunExecutor(settings.catalogue());
    threads = settings.threads();
  }

  @Override
  public void run(List<RunPlan> plans, List<RunTask> tasks, Finished finished) throws IOException {
    ExecutorService pool = Executors.newFixedThreadPool(threads);
    try {
      List<Future<?>> futures = new ArrayList<>();
      for (RunTask task : tasks) {
        futures.add(
            pool.submit(
                () -> {
                  Outcome outcome = Outcome.of(executor, plans.get(task.plan()), task.repeat());
                  finished.take(task, outcome);
                  return null;
                }));
      }
      for (Future<?> future : futures) {
        await(future);
      }
    } finally {
      pool.shutdownNow();
    }
  }

  private static void await(Future<?> task) throws IOException {
    try {
      task.get();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      throw new IOException("interrupted", e);
    } catch (ExecutionException e) {
      if (e.getCause() instanceof RuntimeException fault) {
        throw fault;
      }
      if (e.getCause() instanceof IOException fault) {
        throw fault;
      }
      if (e.getCause() instanceof Error fault) {
        throw fault;
      }
      throw new IllegalStateException(e.getCause());
    }
  }
}
