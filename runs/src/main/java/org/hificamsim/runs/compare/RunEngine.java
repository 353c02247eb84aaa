package org.hificamsim.runs.compare;

import java.io.IOException;
import java.util.List;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.runs.RunPlan;

/**
 * Computes the runs of a comparison, on the threads of this machine or on a cluster. Runs are
 * independent of each other, so an engine may compute them anywhere and in any order.
 *
 * <p>An implementation provides {@link #name} and {@link #run}, has a public constructor without
 * arguments, and is found as a service. It must pass {@code RunEngineContract}.
 */
public interface RunEngine {
  /** The name by which users choose the engine. */
  String name();

  /**
   * Takes the settings; called once, before {@link #run}.
   *
   * @throws org.hificamsim.core.InputException when the engine cannot work with them
   */
  default void configure(EngineSettings settings) {}

  /**
   * Computes every task and returns when the last result has been taken.
   *
   * <p>The first exception of a run or of {@code finished} ends the call with that exception; tasks
   * that have not begun are then dropped.
   *
   * @param plans the plans to which the tasks refer
   * @param tasks the tasks, perhaps none
   * @param finished receives each run once, as soon as it is finished; called from any thread
   */
  void run(List<RunPlan> plans, List<RunTask> tasks, Finished finished) throws IOException;

  /** Receives finished runs. */
  @FunctionalInterface
  interface Finished {
    /** Receives a run; several threads may call this at the same time. */
    void take(RunTask task, FinishedRun run) throws IOException;
  }

  /** The engine of this machine, then those on the class path. */
  static Registry<RunEngine> registry() {
    return new Registry<RunEngine>("engine")
        .register(LocalEngine.NAME, "the threads of this machine", LocalEngine::new)
        .registerServices(RunEngine.class, RunEngine::name, (engine, options) -> {});
  }
}
