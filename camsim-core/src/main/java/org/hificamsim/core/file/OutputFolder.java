package org.hificamsim.core.file;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.io.Writer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.stream.Stream;
import java.util.zip.GZIPOutputStream;
import org.hificamsim.core.InputException;

/**
 * A folder that receives a set of files at once, from one process at a time. They are written in a
 * hidden folder inside it, and {@link #commit} moves them out. Closed without that, it leaves the
 * folder as it was.
 */
public final class OutputFolder implements Closeable {
  private static final String DRAFTS = ".hificamsim";
  private static final String LOCK = "lock";

  private final Path folder;
  private final Path drafts;
  private final FileChannel lock;
  private final Set<String> names = new LinkedHashSet<>();
  private final Set<String> written = new LinkedHashSet<>();

  /**
   * Makes the folder where it is missing.
   *
   * @throws InputException when the path is a file, cannot be made, or is in use
   */
  public OutputFolder(Path folder) {
    this.folder = made(folder);
    this.drafts = folder.resolve(DRAFTS);
    try {
      lock = locked();
      Unfinished.add(this);
      deleteDrafts(); // of a process that was killed
    } catch (FileAlreadyExistsException | NoSuchFileException e) {
      throw inUse(e);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  /**
   * Makes a folder where it is missing.
   *
   * @return the folder
   * @throws InputException when the path is a file or cannot be made
   */
  public static Path made(Path folder) {
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
    return folder;
  }

  /** What the system says of it; where that is the path alone, the kind of problem. */
  private static String reason(IOException e) {
    return e instanceof FileSystemException system && system.getReason() != null
        ? system.getReason()
        : e.getClass().getSimpleName();
  }

  /** Takes the lock that keeps every other process, and every other folder of this one, away. */
  private FileChannel locked() throws IOException {
    if (!Files.exists(drafts, LinkOption.NOFOLLOW_LINKS)) {
      Files.createDirectory(drafts);
    } else if (!Files.isDirectory(drafts, LinkOption.NOFOLLOW_LINKS)) {
      throw new InputException(
          "'" + drafts + "' is a link or a file, expected a folder or nothing");
    }
    Path file = drafts.resolve(LOCK);
    FileChannel channel =
        FileChannel.open(
            file, StandardOpenOption.CREATE, StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS);
    if (!isLocked(channel) || !Files.exists(file)) { // gone: its holder has just finished
      channel.close();
      throw inUse(null);
    }
    return channel;
  }

  private static boolean isLocked(FileChannel channel) throws IOException {
    try {
      return channel.tryLock() != null;
    } catch (OverlappingFileLockException e) {
      return false;
    }
  }

  private InputException inUse(IOException cause) {
    return new InputException(
        "folder '" + folder + "' is in use by another run, expected a folder of its own", cause);
  }

  /** Where the files appear. */
  public Path path() {
    return folder;
  }

  /** A writer (UTF-8), compressed if the name ends in {@code .gz}; to be closed before a commit. */
  public Writer open(String name) throws IOException {
    OutputStream out = stream(name);
    return OutputFile.writer(name.endsWith(".gz") ? new GZIPOutputStream(out, 1 << 16) : out);
  }

  /** A stream for a file of this name; the caller closes it before {@link #commit}. */
  public synchronized OutputStream stream(String name) throws IOException {
    names.add(name);
    return OutputFile.stream(drafts.resolve(name));
  }

  /**
   * Moves every file opened into place, and removes what an earlier run left under {@code stale}.
   */
  public synchronized void commit(List<String> stale) throws IOException {
    for (String name : names) {
      OutputFile.move(drafts.resolve(name), folder.resolve(name));
    }
    for (String name : stale) {
      if (!names.contains(name)) {
        Files.deleteIfExists(folder.resolve(name));
      }
    }
    written.addAll(names);
    names.clear();
  }

  /** The files that commits have moved into place. */
  public synchronized List<String> written() {
    return List.copyOf(written);
  }

  /** Removes whatever has not been committed, and lets others use the folder. */
  @Override
  public synchronized void close() throws IOException {
    if (lock.isOpen()) {
      try (lock) {
        deleteDrafts();
        Files.delete(drafts.resolve(LOCK));
        Files.delete(drafts);
      } catch (DirectoryNotEmptyException e) {
        // the next one is in it already
      } finally {
        Unfinished.remove(this);
      }
    }
  }

  private void deleteDrafts() throws IOException {
    try (Stream<Path> files = Files.list(drafts)) {
      for (Path file : files.filter(file -> !file.endsWith(LOCK)).toList()) {
        Files.delete(file);
      }
    }
  }
}
