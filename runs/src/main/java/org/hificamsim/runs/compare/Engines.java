package org.hificamsim.runs.compare;

import org.hificamsim.core.registry.Registry;

/** The engines: the one that comes with the simulator, then those on the class path. */
public final class Engines {
  private Engines() {}

  /** The engines of this class path. */
  public static Registry<RunEngine> registry() {
    return new Registry<RunEngine>("engine")
        .register(LocalEngine.NAME, "the threads of this machine", LocalEngine::new)
        .registerServices(RunEngine.class, RunEngine::name, (engine, options) -> {});
  }
}
