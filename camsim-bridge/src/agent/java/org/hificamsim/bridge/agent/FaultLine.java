package org.hificamsim.bridge.agent;

/** Reports problems of the bridge, each in one line on standard error. */
public final class FaultLine {
  private static final int STOPPED_EXIT_CODE = 2;

  private FaultLine() {}

  /**
   * Reports a problem.
   *
   * @param strict whether the JVM stops, with exit code 2; else CamSim runs on without the bridge
   */
  public static void report(String problem, boolean strict) {
    String outcome = strict ? "stopped, as strict=true asks" : "CamSim runs on unchanged";
    note(problem + "; " + outcome);
    if (strict) {
      System.exit(STOPPED_EXIT_CODE);
    }
  }

  /** Prints a note. */
  public static void note(String text) {
    System.err.println("hificamsim-bridge: " + text);
  }

  /** Returns whether options contain {@code strict=true}, even if they are invalid otherwise. */
  public static boolean isStrict(String options) {
    return ("," + options.replace(" ", "") + ",").contains(",strict=true,");
  }
}
