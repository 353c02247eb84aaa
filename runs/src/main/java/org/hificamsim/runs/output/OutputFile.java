package org.hificamsim.runs.output;

import java.io.BufferedOutputStream;
import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import org.hificamsim.core.InputException;

/**
 * A file that appears at once: written under a temporary name and moved into place by {@link
 * #commit}. Closed without that, it leaves an earlier file as it was.
 */
public final class OutputFile implements Closeable {
  private final Path path;
  private final Path temporary;
  private boolean done;

  /**
   * @param option the option that names the file, for error lines
   * @throws InputException when the path is a folder or its folder is missing or not writable
   */
  public OutputFile(String option, Path path) {
    this.path = path;
    Path folder = path.toAbsolutePath().getParent();
    if (Files.isDirectory(path) || folder == null) {
      throw new InputException(option + " '" + path + "' is a folder, expected a file");
    }
    if (!Files.isDirectory(folder) || !Files.isWritable(folder)) {
      throw new InputException(
          option + " '" + path + "' cannot be made, expected a folder that exists and is writable");
    }
    temporary =
        folder.resolve(".%s-%d.part".formatted(path.getFileName(), ProcessHandle.current().pid()));
  }

  /** A writer (UTF-8); the caller closes it before {@link #commit}. */
  public Writer open() throws IOException {
    return new BufferedWriter(Files.newBufferedWriter(temporary, StandardCharsets.UTF_8), 1 << 16);
  }

  /** A stream; the caller closes it before {@link #commit}. */
  public OutputStream stream() throws IOException {
    return new BufferedOutputStream(Files.newOutputStream(temporary), 1 << 16);
  }

  /** Moves the file into place. */
  public void commit() throws IOException {
    Files.move(
        temporary, path, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
    done = true;
  }

  @Override
  public void close() throws IOException {
    if (!done) {
      Files.deleteIfExists(temporary);
    }
  }
}
