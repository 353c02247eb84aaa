package org.hificamsim.runs.output;

import java.io.BufferedWriter;
import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.OutputStreamWriter;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.charset.StandardCharsets;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardCopyOption;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.regex.Matcher;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import java.util.zip.GZIPOutputStream;
import org.hificamsim.core.InputException;

/**
 * A folder that receives a set of files at once: each is written under a temporary name and moved
 * into place by {@link #commit}. Closed without that, it leaves the folder as it was.
 */
public final class OutputFolder implements Closeable {
  private static final Pattern TEMPORARY = Pattern.compile("\\..+-(\\d{1,18})\\.part");

  private final Path folder;
  private final Map<String, Path> pending = new LinkedHashMap<>();

  /**
   * Makes the folder where it is missing.
   *
   * @throws InputException when the path is a file or cannot be made
   */
  public OutputFolder(Path folder) {
    this.folder = folder;
    if (folder.toString().isEmpty()) {
      throw new InputException("the folder for results has an empty name, expected one");
    }
    if (Files.exists(folder) && !Files.isDirectory(folder)) {
      throw new InputException("folder '" + folder + "' is a file, expected a folder");
    }
    try {
      Files.createDirectories(folder);
    } catch (IOException e) {
      throw new InputException("folder '" + folder + "' cannot be made: " + reason(e), e);
    }
    if (!Files.isWritable(folder)) {
      throw new InputException(
          "folder '" + folder + "' is not writable, expected a folder that is");
    }
    removeLeftovers();
  }

  /** What the system says of it; where that is the path alone, the kind of problem. */
  private static String reason(IOException e) {
    return e instanceof FileSystemException told && told.getReason() != null
        ? told.getReason()
        : e.getClass().getSimpleName();
  }

  /** Removes what processes that were killed have left under temporary names. */
  private void removeLeftovers() {
    try (Stream<Path> files = Files.list(folder)) {
      for (Path file : files.toList()) {
        Matcher name = TEMPORARY.matcher(file.getFileName().toString());
        if (name.matches() && ProcessHandle.of(Long.parseLong(name.group(1))).isEmpty()) {
          Files.deleteIfExists(file);
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** A writer (UTF-8) for a file of this name; the caller closes it before {@link #commit}. */
  public Writer open(String name) throws IOException {
    return new BufferedWriter(
        new OutputStreamWriter(stream(name), StandardCharsets.UTF_8), 1 << 16);
  }

  /** A writer (UTF-8) for a file that is compressed with gzip. */
  public Writer openCompressed(String name) throws IOException {
    return new BufferedWriter(
        new OutputStreamWriter(new GZIPOutputStream(stream(name), 1 << 16), StandardCharsets.UTF_8),
        1 << 16);
  }

  /** A stream for a file of this name; the caller closes it before {@link #commit}. */
  public OutputStream stream(String name) throws IOException {
    Path temporary = folder.resolve("." + name + "-" + ProcessHandle.current().pid() + ".part");
    pending.put(name, temporary);
    return Files.newOutputStream(temporary);
  }

  /**
   * Moves every file opened into place, and removes what an earlier run left under {@code stale}.
   */
  public void commit(List<String> stale) throws IOException {
    for (Map.Entry<String, Path> file : pending.entrySet()) {
      Files.move(
          file.getValue(),
          folder.resolve(file.getKey()),
          StandardCopyOption.ATOMIC_MOVE,
          StandardCopyOption.REPLACE_EXISTING);
    }
    for (String name : stale) {
      if (!pending.containsKey(name)) {
        Files.deleteIfExists(folder.resolve(name));
      }
    }
    pending.clear();
  }

  /** Removes whatever has not been committed. */
  @Override
  public void close() throws IOException {
    for (Path temporary : pending.values()) {
      Files.deleteIfExists(temporary);
    }
    pending.clear();
  }
}
