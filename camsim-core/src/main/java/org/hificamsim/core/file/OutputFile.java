package org.hificamsim.core.file;

import static org.hificamsim.core.NamedSetting.setting;

import java.io.BufferedOutputStream;
import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.nio.file.StandardOpenOption;
import java.util.UUID;
import org.hificamsim.core.InputException;

/**
 * A file that appears as a whole: it is written next to its place under a unique name and moved
 * there by {@link #commit}. Closing it without a commit leaves an existing file unchanged.
 */
public final class OutputFile implements Closeable {
  private static final int BUFFER = 1 << 16;

  private final Path path;
  private final Path draft;
  private final boolean replaces;

  /** Prepares a file in an existing folder, which may replace another; nothing is written yet. */
  public OutputFile(Path path) {
    this(path, true);
  }

  private OutputFile(Path path, boolean replaces) {
    this.path = path.toAbsolutePath();
    this.replaces = replaces;
    this.draft = this.path.resolveSibling(".hificamsim-" + UUID.randomUUID() + ".part");
  }

  /**
   * Prepares a file that a setting names.
   *
   * @param option the name of the setting, for messages
   * @param replaces whether an existing file may be replaced
   * @throws InputException if the file exists and may not be replaced, the path is a folder, or its
   *     folder is missing or not writable
   */
  public static OutputFile of(String option, Path path, boolean replaces) {
    Path folder = path.toAbsolutePath().getParent();
    if (Files.isDirectory(path) || folder == null) {
      throw new InputException(option + " '" + path + "' is a folder, expected a file");
    }
    if (!Files.isDirectory(folder) || !Files.isWritable(folder)) {
      throw InputException.of(
          "%s '%s' cannot be made, expected a folder that exists and is writable", option, path);
    }
    OutputFile file = new OutputFile(path, replaces);
    file.requireFree(option + " ");
    return file;
  }

  /**
   * Prepares a file that a setting names, and creates its folder if it is missing.
   *
   * @param option the name of the setting, for messages
   * @param replaces whether an existing file may be replaced
   * @throws InputException if the file exists and may not be replaced, the path is a folder, or its
   *     folder cannot be created or written
   */
  public static OutputFile inFolder(String option, Path path, boolean replaces) {
    Path folder = path.toAbsolutePath().getParent();
    if (folder != null) {
      OutputFolder.create(folder);
    }
    return of(option, path, replaces);
  }

  private void requireFree(String option) {
    if (!replaces && Files.exists(path, LinkOption.NOFOLLOW_LINKS)) {
      throw InputException.of(
          "%s'%s' exists, expected a new file, or %s to replace it",
          option, path, setting("force"));
    }
  }

  /** The content of a file. */
  @FunctionalInterface
  public interface Content {
    /** Writes the content. */
    void write(OutputStream out) throws IOException;
  }

  /** Writes the whole file. */
  public void write(Content content) throws IOException {
    try (this) {
      try (OutputStream out = stream()) {
        content.write(out);
      }
      commit();
    }
  }

  /** Writes a text in UTF-8. */
  public void write(String text) throws IOException {
    write(out -> out.write(text.getBytes(StandardCharsets.UTF_8)));
  }

  /** Opens a writer (UTF-8), which the caller closes before {@link #commit}. */
  public Writer open() throws IOException {
    return writer(stream());
  }

  /** Opens a stream, which the caller closes before {@link #commit}. */
  public synchronized OutputStream stream() throws IOException {
    Unfinished.add(this);
    return stream(draft);
  }

  /** Moves the file into place. */
  public synchronized void commit() throws IOException {
    requireFree("");
    move(draft, path);
    Unfinished.remove(this);
  }

  @Override
  public synchronized void close() throws IOException {
    Files.deleteIfExists(draft);
    Unfinished.remove(this);
  }

  /** Opens a stream to a new file; fails if anything exists there, even a link. */
  static OutputStream stream(Path draft) throws IOException {
    return new BufferedOutputStream(
        Files.newOutputStream(draft, StandardOpenOption.CREATE_NEW, StandardOpenOption.WRITE),
        BUFFER);
  }

  static Writer writer(OutputStream out) {
    return new BufferedWriter(new OutputStreamWriter(out, StandardCharsets.UTF_8), BUFFER);
  }

  static void move(Path draft, Path destination) throws IOException {
    Files.move(
        draft, destination, StandardCopyOption.ATOMIC_MOVE, StandardCopyOption.REPLACE_EXISTING);
  }
}
