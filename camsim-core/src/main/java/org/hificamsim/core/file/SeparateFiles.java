package org.hificamsim.core.file;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.hificamsim.core.InputException;

/** The files of one command, no two of which may be one, by a link neither. */
public final class SeparateFiles {
  private final Map<Path, String> options = new HashMap<>();

  /**
   * One file more.
   *
   * @param option that names it
   * @throws InputException when another option names it, too
   */
  public SeparateFiles with(String option, Path file) {
    String other = options.putIfAbsent(real(file), option);
    if (other != null) {
      throw InputException.of("%s and %s are one file, '%s', expected two", other, option, file);
    }
    return this;
  }

  /** A file's one path: where links lead, as far as there is anything yet. */
  public static Path real(Path file) {
    try {
      return file.toRealPath();
    } catch (IOException e) {
      Path whole = file.toAbsolutePath().normalize();
      Path folder = whole.getParent();
      return folder == null ? whole : real(folder).resolve(whole.getFileName());
    }
  }
}
