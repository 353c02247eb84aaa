package org.hificamsim.cli;

import picocli.CommandLine.Option;

/** The option {@code --threads}; results do not depend on it. */
final class ThreadsOption {
  private static final int MAX_THREADS = 1024;

  @Option(names = "--threads", paramLabel = "N")
  private int threads;

  /**
   * The number of threads, 1 or more.
   *
   * @throws org.hificamsim.core.InputException when the number is out of range
   */
  int count() {
    int count = Numbers.inRange("--threads", threads, 0, MAX_THREADS);
    return count == 0 ? Runtime.getRuntime().availableProcessors() : count;
  }
}
