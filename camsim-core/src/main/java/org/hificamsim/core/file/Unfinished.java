package org.hificamsim.core.file;

import java.io.Closeable;
import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** Files and folders that are being written: closing one deletes what has not been committed. */
public final class Unfinished {
  static final Set<Closeable> ALL = new HashSet<>();
  static boolean ending;

  private Unfinished() {}

  /** Deletes them when the process ends, by Ctrl-C or a signal too. For programs, not libraries. */
  public static void deleteAtExit() {
    Runtime.getRuntime().addShutdownHook(new Thread(Unfinished::closeAll, "unfinished files"));
  }

  /**
   * Adds one.
   *
   * @throws IOException when the process is ending
   */
  static synchronized void add(Closeable one) throws IOException {
    if (ending) {
      throw new IOException("the program is ending");
    }
    ALL.add(one);
  }

  static synchronized void remove(Closeable one) {
    ALL.remove(one);
  }

  static void closeAll() {
    for (Closeable one : end()) {
      try {
        one.close();
      } catch (IOException e) {
        // the others can still be deleted
      }
    }
  }

  private static synchronized List<Closeable> end() {
    ending = true;
    return List.copyOf(ALL);
  }
}
