package org.hificamsim.core.file;

import java.io.IOException;
import java.io.InputStream;
import java.io.UncheckedIOException;

/** Reading and writing where no fault is expected: one goes on as an UncheckedIOException. */
public final class Io {
  /** Reads something. */
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

  /** What is read. */
  public static <T> T get(Source<T> source) {
    try {
      return source.get();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** Reads or writes. */
  public static void run(Task task) {
    get(
        () -> {
          task.run();
          return null;
        });
  }

  /** The content of a file that stands next to a class. */
  public static byte[] resource(Class<?> next, String name) {
    try (InputStream in = next.getResourceAsStream(name)) {
      return in.readAllBytes();
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
