package org.hificamsim.runs.compare;

import static org.hificamsim.core.NamedSetting.setting;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;

/** Computes runs on the threads of this machine. */
public final class LocalEngine implements RunEngine {
  /** The name of the default engine. */
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
              throw InputException.of(
                  "%s '%s' has no effect with %s, expected none",
                  setting("master"), master, setting("engine", NAME));
            });
    executor = new RunExecutor(settings.catalogue());
    threads = settings.threads();
  }

  @Override
  public void run(List<RunPlan> plans, List<RunTask> tasks, Finished finished) throws IOException {
    try {
      Parallel.map(
          tasks,
          threads,
          task -> {
            FinishedRun run = FinishedRun.of(executor, plans.get(task.plan()), task.repeat());
            Io.run(() -> finished.take(task, run));
            return task;
          });
    } catch (UncheckedIOException e) {
      throw e.getCause();
    }
  }
}
