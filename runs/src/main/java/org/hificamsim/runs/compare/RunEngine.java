package org.hificamsim.runs.compare;

import java.io.IOException;
import java.util.List;
import org.hificamsim.core.registry.Registry;
import org.hificamsim.runs.RunPlan;

/**
 * Where the runs of a comparison are computed: this machine's threads, a cluster. Runs know nothing
 * of each other, so that an engine may compute them anywhere, in any order.
 *
 * <p>An implementation writes {@link #name} and {@link #run}, has a public constructor without
 * arguments, and is found as a service. It must keep what {@code RunEngineContract} tests.
 */
public interface RunEngine {
  /** The name that {@code --engine} takes. */
  String name();

  /**
   * Takes the settings of the command line; called once, before {@link #run}.
   *
   * @throws org.hificamsim.core.InputException when the engine cannot work with them
   */
  default void configure(EngineSettings settings) {}

  /**
   * Computes every task and returns when the last has been taken.
   *
   * <p>The first exception that a run or {@code finished} throws ends the call with that exception;
   * tasks that have not begun are dropped then.
   *
   * @param plans what the tasks refer to
   * @param tasks may be empty
   * @param finished takes each finished run once, as soon as it is there; called from any thread
   */
  void run(List<RunPlan> plans, List<RunTask> tasks, Finished finished) throws IOException;

  /** Takes finished runs. */
  @FunctionalInterface
  interface Finished {
    /** Takes one; several threads may call at a time. */
    void take(RunTask task, FinishedRun run) throws IOException;
  }

  /** The engines: the one that comes with the simulator, then those on the class path. */
  static Registry<RunEngine> registry() {
    return new Registry<RunEngine>("engine")
        .register(LocalEngine.NAME, "the threads of this machine", LocalEngine::new)
        .registerServices(RunEngine.class, RunEngine::name, (engine, options) -> {});
  }
}
