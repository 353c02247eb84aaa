package org.hificamsim.cli;

import java.lang.reflect.Proxy;

/** Says when a search is to end: after some time, or at the first Ctrl-C; a second one ends all. */
final class Interrupt {
  private final long start = System.nanoTime();
  private final double seconds;
  private volatile boolean interrupted;

  Interrupt(double seconds) {
    this.seconds = seconds;
    listen();
  }

  boolean isDue() {
    return isDue(1);
  }

  /** The same where a share of the time is enough. */
  boolean isDue(double share) {
    return interrupted || System.nanoTime() - start > share * seconds * 1e9;
  }

  /** By reflection: the compiler warns of the JDK's one class for signals, though it stays. */
  private void listen() {
    try {
      Class<?> signal = Class.forName("sun.misc.Signal");
      Class<?> handler = Class.forName("sun.misc.SignalHandler");
      Object first = signal.getConstructor(String.class).newInstance("INT");
      Object taken =
          Proxy.newProxyInstance(
              Interrupt.class.getClassLoader(),
              new Class<?>[] {handler},
              (proxy, method, arguments) -> {
                if (interrupted) {
                  Runtime.getRuntime().exit(130);
                }
                interrupted = true;
                return null;
              });
      signal.getMethod("handle", signal, handler).invoke(null, first, taken);
    } catch (ReflectiveOperationException | IllegalArgumentException e) {
      // a JVM without signals: then Ctrl-C ends the program, and --time the search
    }
  }
}
