package org.hificamsim.experiments.cli;

import java.util.Optional;
import org.hificamsim.experiments.catalogue.Catalogue;
import org.hificamsim.experiments.compare.EngineSettings;
import org.hificamsim.experiments.compare.Engines;
import org.hificamsim.experiments.compare.LocalEngine;
import org.hificamsim.experiments.compare.RunEngine;
import picocli.CommandLine.Option;

/** The options of commands that run many plans. */
final class BatchOptions {
  private static final int MOST_STEPS = 10_000_000;
  private static final int MOST_REPEATS = 100_000;
  private static final int MOST_THREADS = 1024;

  @Option(names = "--seed", paramLabel = "N", defaultValue = "0", description = "First seed.")
  private long seed;

  @Option(names = "--resume", description = "Keep the runs that a killed command finished.")
  private boolean resume;

  @Option(
      names = "--threads",
      paramLabel = "N",
      defaultValue = "0",
      description = "Threads; 0 for one per processor. Results do not depend on it.")
  private int threads;

  @Option(
      names = "--engine",
      paramLabel = "local|spark",
      defaultValue = LocalEngine.NAME,
      description = "Where to compute. Results do not depend on it.")
  private String engine;

  @Option(
      names = "--master",
      paramLabel = "URL",
      description = "The cluster's master for --engine spark: spark://HOST:PORT, local[*], yarn.")
  private String master;

  /** Checks the numbers, those of the command with them. */
  void check(int steps, int repeats) {
    Numbers.inRange("--steps", steps, 1, MOST_STEPS);
    Numbers.inRange("--repeat", repeats, 1, MOST_REPEATS);
    Numbers.seeds(seed, repeats);
    Numbers.inRange("--threads", threads, 0, MOST_THREADS);
  }

  long seed() {
    return seed;
  }

  boolean resume() {
    return resume;
  }

  /**
   * The engine that was asked for.
   *
   * @throws org.hificamsim.core.InputException when there is none of that name, or it cannot work
   */
  RunEngine engine(Catalogue catalogue) {
    RunEngine made = Engines.registry().create(engine);
    made.configure(new EngineSettings(catalogue, threads(), Optional.ofNullable(master)));
    return made;
  }

  private int threads() {
    return threads == 0 ? Runtime.getRuntime().availableProcessors() : threads;
  }
}
