package org.hificamsim.core.file;

import java.io.Closeable;
import java.io.IOException;
import java.util.HashSet;
import java.util.List;
import java.util.Set;

/** The files and folders that are being written; closing one deletes what is not committed. */
public final class Unfinished {
  static final Set<Closeable> ALL = new HashSet<>();
  static boolean ending;

  private Unfinished() {}

  /**
   * Deletes all unfinished files when the process ends, also by a signal. For programs, not for
   * libraries.
   */
  public static void deleteAtExit() {
    Runtime.getRuntime().addShutdownHook(new Thread(Unfinished::closeAll, "unfinished files"));
  }

  /**
   * Adds a file or folder.
   *
   * @throws IOException if the process is ending
   */
  static synchronized void add(Closeable unfinished) throws IOException {
    if (ending) {
      throw new IOException("the program is ending");
    }
    ALL.add(unfinished);
  }

  static synchronized void remove(Closeable unfinished) {
    ALL.remove(unfinished);
  }

  static void closeAll() {
    for (Closeable unfinished : end()) {
      try {
        unfinished.close();
      } catch (IOException e) {
        // go on deleting the others
      }
    }
  }

  private static synchronized List<Closeable> end() {
    ending = true;
    return List.copyOf(ALL);
  }
}
