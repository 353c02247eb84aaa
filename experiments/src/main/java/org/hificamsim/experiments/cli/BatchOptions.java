package org.hificamsim.experiments.cli;

import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options of commands that run many plans. */
final class BatchOptions {
  private static final int MOST_STEPS = 10_000_000;
  private static final int MOST_REPEATS = 100_000;
  private static final int MOST_THREADS = 1024;

  @Option(names = "--seed", paramLabel = "N", defaultValue = "0", description = "First seed.")
  private long seed;

  @Mixin private QuietOption quiet;

  @Option(names = "--resume", description = "Keep the runs that a killed command finished.")
  private boolean resume;

  @Option(
      names = "--threads",
      paramLabel = "N",
      defaultValue = "0",
      description = "Threads; 0 for one per processor. Results do not depend on it.")
  private int threads;

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

  QuietOption quiet() {
    return quiet;
  }

  int threads() {
    return threads == 0 ? Runtime.getRuntime().availableProcessors() : threads;
  }
}
