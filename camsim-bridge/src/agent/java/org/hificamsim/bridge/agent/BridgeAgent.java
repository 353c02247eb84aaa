package org.hificamsim.bridge.agent;

import java.lang.instrument.Instrumentation;
import java.net.URL;
import java.util.function.BiConsumer;

/**
 * Starts the bridge: the Java agent {@code -javaagent:hificamsim-bridge.jar=OPTIONS}. It is
 * compiled for Java 8, so that an older JVM prints one line and not a stack trace.
 */
public final class BridgeAgent {
  private static final String INSTALLER = "org.hificamsim.bridge.Installer";
  private static final double MIN_JAVA = 17;

  private BridgeAgent() {}

  /**
   * Called by the JVM before CamSim's main method. Without options nothing is loaded or changed.
   */
  public static void premain(String options, Instrumentation instrumentation) {
    if (options == null || options.trim().isEmpty()) {
      return;
    }
    String java = System.getProperty("java.specification.version");
    if (Double.parseDouble(java) < MIN_JAVA) {
      refuse(options, "Java 17 or later is needed, this is " + java);
      return;
    }
    try {
      installer().accept(options, instrumentation);
    } catch (ReflectiveOperationException | java.io.IOException | LinkageError e) {
      refuse(options, "the agent's jar is not whole: " + e);
    }
  }

  @SuppressWarnings("unchecked") // Installer implements this interface
  private static BiConsumer<String, Instrumentation> installer()
      throws ReflectiveOperationException, java.io.IOException {
    URL jar = BridgeAgent.class.getProtectionDomain().getCodeSource().getLocation();
    Class<?> installer = new IsolatedLoader(jar).loadClass(INSTALLER);
    return (BiConsumer<String, Instrumentation>) installer.getConstructor().newInstance();
  }

  private static void refuse(String options, String problem) {
    FaultLine.report(problem, FaultLine.isStrict(options));
  }
}
