package org.hificamsim.cli;

import picocli.CommandLine.Option;

/** {@code --threads} of commands whose results do not depend on it. */
final class ThreadsOption {
  private static final int MOST_THREADS = 1024;

  @Option(
      names = "--threads",
      paramLabel = "N",
      defaultValue = "0",
      description = "Threads; 0 for one per processor. Results do not depend on it.")
  private int threads;

  /** The number of threads to use, checked. */
  int count() {
    Numbers.inRange("--threads", threads, 0, MOST_THREADS);
    return threads == 0 ? Runtime.getRuntime().availableProcessors() : threads;
  }
}
