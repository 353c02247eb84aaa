package org.hificamsim.core.file;

import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import org.hificamsim.core.InputException;

/** The files of one command, which must all be different, even through links. */
public final class SeparateFiles {
  private final Map<Path, String> options = new HashMap<>();

  /**
   * Adds a file.
   *
   * @param option the setting that names the file, for messages
   * @throws InputException if another setting names the same file
   */
  public SeparateFiles with(String option, Path file) {
    String other = options.putIfAbsent(real(file), option);
    if (other != null) {
      throw InputException.of("%s and %s are one file, '%s', expected two", other, option, file);
    }
    return this;
  }

  /** The canonical path of a file, with links resolved as far as the path exists. */
  public static Path real(Path file) {
    try {
      return file.toRealPath();
    } catch (IOException e) {
      Path absolute = file.toAbsolutePath().normalize();
      Path folder = absolute.getParent();
      return folder == null ? absolute : real(folder).resolve(absolute.getFileName());
    }
  }
}
