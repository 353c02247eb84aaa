package org.hificamsim.cli;

import java.lang.reflect.Proxy;
import java.time.Duration;
import java.time.Instant;

/** Ends a search after some time, or at the first Ctrl-C. A second Ctrl-C ends the program. */
final class Interrupt {
  private final Instant start;
  private final double seconds;
  private volatile boolean interrupted;

  Interrupt(Instant start, double seconds) {
    this.start = start;
    this.seconds = seconds;
    listen();
  }

  /** Whether the search is to end. */
  boolean isDue() {
    return isDue(1);
  }

  /** Whether a part of the search that has a share of the time is to end. */
  boolean isDue(double share) {
    return interrupted || passed() > share * seconds;
  }

  /** The share of the time that has passed, 1 at most. */
  double share() {
    return Math.min(1, passed() / seconds);
  }

  private double passed() {
    return Duration.between(start, Instant.now()).toNanos() / 1e9;
  }

  /**
   * Listens for Ctrl-C by reflection, because the compiler warns of the JDK's only class for
   * signals.
   */
  private void listen() {
    try {
      Class<?> signal = Class.forName("sun.misc.Signal");
      Class<?> handler = Class.forName("sun.misc.SignalHandler");
      Object ctrlC = signal.getConstructor(String.class).newInstance("INT");
      Object listener =
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
      signal.getMethod("handle", signal, handler).invoke(null, ctrlC, listener);
    } catch (ReflectiveOperationException | IllegalArgumentException e) {
      // without signals, Ctrl-C ends the program and --time the search
    }
  }
}
