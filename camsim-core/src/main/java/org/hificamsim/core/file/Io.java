package org.hificamsim.core.file;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;

/** Runs input and output whose errors are not expected, and rethrows them unchecked. */
public final class Io {
  /** Reads a value. */
  @FunctionalInterface
  public interface Source<T> {
    T get() throws IOException;
  }

  /** Reads or writes. */
  @FunctionalInterface
  public interface Task {
    void run() throws IOException;
  }

  private Io() {}

  /** Returns what a source reads. */
  public static <T> T get(Source<T> source) {
    try {
      return source.get();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Runs a task. */
  public static void run(Task task) {
    get(
        () -> {
          task.run();
          return null;
        });
  }

  /** Reads a resource in the package of a class. */
  public static byte[] resource(Class<?> neighbour, String name) {
    try (InputStream in = neighbour.getResourceAsStream(name)) {
      return in.readAllBytes();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
