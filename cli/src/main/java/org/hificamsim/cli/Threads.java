package org.hificamsim.cli;

/** The option {@code --threads}. */
final class Threads {
  private static final int MOST = 1024;

  private Threads() {}

  /** Refuses a number out of range. */
  static void check(int threads) {
    Numbers.inRange("--threads", threads, 0, MOST);
  }

  /** The number of threads; 0 stands for one per processor. */
  static int number(int threads) {
    return threads == 0 ? Runtime.getRuntime().availableProcessors() : threads;
  }
}
