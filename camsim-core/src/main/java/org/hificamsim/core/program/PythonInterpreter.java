package org.hificamsim.core.program;

/** The Python that runs a user's files. */
public final class PythonInterpreter {
  /** The environment variable that names another one. */
  public static final String VARIABLE = "HIFICAMSIM_PYTHON";

  /** The system property with the one that called Java, if it was one. */
  public static final String CALLER = "hificamsim.python";

  private PythonInterpreter() {}

  /** Its file, or its name on the path: what the user names, the caller, or {@code python3}. */
  public static String command() {
    String caller = System.getProperty(CALLER, "python3");
    return System.getenv().getOrDefault(VARIABLE, caller);
  }
}
