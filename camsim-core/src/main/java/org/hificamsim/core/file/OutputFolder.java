package org.hificamsim.core.file;

import java.io.Closeable;
import java.io.IOException;
import java.io.OutputStream;
import java.io.Writer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.FileAlreadyExistsException;
import java.nio.file.FileSystemException;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.NoSuchFileException;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Collection;
import java.util.HashSet;
import java.util.LinkedHashMap;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Stream;
import java.util.zip.GZIPOutputStream;
import org.hificamsim.core.InputException;

/**
 * A folder that receives a set of files at once, from one process at a time.
 *
 * <p>The files are drafted in a hidden folder inside it. {@link #commit} puts the future {@link
 * FileRecord} of the folder in place by one atomic move. A process killed before that leaves the
 * folder unchanged; if it is killed afterwards, the next process that opens the folder moves the
 * remaining files. Files that no command wrote, or that have changed since, are neither replaced
 * nor removed.
 */
public final class OutputFolder implements Closeable {
  private static final String DRAFTS = ".hificamsim";
  private static final String LOCK = "lock";
  private static final String COMMITTED = "commit";

  private final Path folder;
  private final Path drafts;
  private final Runnable beforeChange;
  private final FileChannel lock;
  private FileRecord record;
  private final Set<Path> inputs = new HashSet<>();

  /** The drafted files with their SHA-256, empty until it is computed. */
  private final Map<String, String> drafted = new LinkedHashMap<>();

  /**
   * Opens the folder, creates it if it is missing, and finishes the commit of a killed process.
   *
   * @throws InputException if the path is a file, cannot be created, or is in use
   */
  public OutputFolder(Path folder) {
    this(folder, () -> {});
  }

  /**
   * @param beforeChange action to run before each change on the disk
   */
  OutputFolder(Path folder, Runnable beforeChange) {
    this.folder = create(folder);
    this.drafts = folder.resolve(DRAFTS);
    this.beforeChange = beforeChange;
    try {
      lock = takeLock();
    } catch (FileAlreadyExistsException | NoSuchFileException e) {
      throw inUse(e);
    } catch (IOException e) {
      throw unusable(e);
    }
    try {
      Unfinished.add(this);
      if (isCommitted(folder)) {
        moveAll();
      }
      // A killed process may have left drafts.
      deleteDrafts();
      record = FileRecord.of(folder);
    } catch (IOException e) {
      release();
      throw unusable(e);
    } catch (RuntimeException | Error e) {
      release();
      throw e;
    }
  }

  /**
   * Finishes the commit of a killed process in a folder that will be read.
   *
   * @throws InputException if that is impossible, so that old and new files are mixed
   */
  public static void settle(Path folder) throws IOException {
    if (isCommitted(folder)) {
      new OutputFolder(folder).close();
    }
  }

  /** Whether commands have written into a folder, or are writing. */
  public static boolean isOutputFolder(Path folder) {
    return Files.exists(folder.resolve(DRAFTS)) || Files.exists(folder.resolve(FileRecord.NAME));
  }

  private static boolean isCommitted(Path folder) {
    return Files.exists(folder.resolve(DRAFTS).resolve(COMMITTED), LinkOption.NOFOLLOW_LINKS);
  }

  /**
   * Creates a folder if it is missing.
   *
   * @return the folder
   * @throws InputException if the path is a file or cannot be created
   */
  public static Path create(Path folder) {
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
      throw InputException.of("folder '%s' is not writable, expected a folder that is", folder);
    }
    return folder;
  }

  /** The reason that the system gives; without one, the kind of error. */
  private static String reason(IOException e) {
    return e instanceof FileSystemException system && system.getReason() != null
        ? system.getReason()
        : e.getClass().getSimpleName();
  }

  /** Takes the lock that excludes other processes, and other users within this one. */
  private FileChannel takeLock() throws IOException {
    if (!Files.exists(drafts, LinkOption.NOFOLLOW_LINKS)) {
      Files.createDirectory(drafts);
    } else if (!Files.isDirectory(drafts, LinkOption.NOFOLLOW_LINKS)) {
      throw InputException.of("'%s' is a link or a file, expected a folder or nothing", drafts);
    }
    Path file = drafts.resolve(LOCK);
    FileChannel channel =
        FileChannel.open(
            file, StandardOpenOption.CREATE, StandardOpenOption.WRITE, LinkOption.NOFOLLOW_LINKS);
    // The file is missing if its holder has just finished.
    if (!isLocked(channel) || !Files.exists(file)) {
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

  private InputException unusable(IOException e) {
    return InputException.of(
            "'%s' cannot be used (%s), expected a folder of our own or nothing",
            drafts, e.getMessage())
        .because(e);
  }

  /** The folder. */
  public Path path() {
    return folder;
  }

  /** The hidden folder of the drafts, whose names have {@code %2F} for a slash. */
  public Path drafts() {
    return drafts;
  }

  /** Protects the input files of the command from being replaced or removed. */
  public void keep(Collection<Path> files) {
    files.forEach(file -> inputs.add(SeparateFiles.real(file)));
  }

  /**
   * Checks in advance that files may be written.
   *
   * @throws InputException if one is an input, or exists and was not written by a command
   */
  public void claim(Collection<String> files) throws IOException {
    for (String name : files) {
      claim(name);
    }
  }

  private void claim(String name) throws IOException {
    Path file = folder.resolve(name);
    if (!FileRecord.isBelow(name)) {
      throw new InputException("'" + name + "' is no file's name, expected one without a path");
    }
    if (inputs.contains(SeparateFiles.real(file))) {
      throw InputException.of(
          "'%s' is an input of this command, expected another folder for its output", file);
    }
    if (Files.exists(file, LinkOption.NOFOLLOW_LINKS) && !record.isUnchanged(folder, name)) {
      throw InputException.of(
          "'%s' would be replaced, and was not written by hificamsim or was changed"
              + " since%s: expected another folder, or the file moved away",
          file, record.names().isEmpty() ? " (versions before 0.2 kept no record of it)" : "");
    }
  }

  /**
   * Opens a writer (UTF-8), compressed if the name ends in {@code .gz}; the caller closes it before
   * {@link #commit}.
   */
  public Writer open(String name) throws IOException {
    OutputStream out = stream(name);
    return OutputFile.writer(name.endsWith(".gz") ? new GZIPOutputStream(out, 1 << 16) : out);
  }

  /** Opens a stream for a file, which the caller closes before {@link #commit}. */
  public synchronized OutputStream stream(String name) throws IOException {
    claim(name);
    if (drafted.put(name, "") != null) {
      // Written earlier by the same command.
      Files.deleteIfExists(draft(name));
    }
    return OutputFile.stream(draft(name));
  }

  /** Writes a whole file. */
  public void write(String name, byte[] content) throws IOException {
    try (OutputStream out = stream(name)) {
      out.write(content);
    }
  }

  /** Writes a whole file of text. */
  public void write(String name, String content) throws IOException {
    write(name, content.getBytes(StandardCharsets.UTF_8));
  }

  /** Copies a file. */
  public void copy(String name, Path file) throws IOException {
    try (OutputStream out = stream(name)) {
      Files.copy(file, out);
    }
  }

  private Path draft(String name) {
    return drafts.resolve(name.replace("/", "%2F"));
  }

  /** The SHA-256 of each drafted file, by name. */
  public synchronized Map<String, String> hashes() throws IOException {
    for (Map.Entry<String, String> file : drafted.entrySet()) {
      if (file.getValue().isEmpty()) {
        file.setValue(Sha256.of(draft(file.getKey())));
      }
    }
    return new TreeMap<>(drafted);
  }

  /**
   * Moves all drafted files into place, and removes the {@code stale} files of earlier commands.
   */
  public synchronized void commit(Collection<String> stale) throws IOException {
    claim(drafted.keySet());
    FileRecord next = record.copy();
    for (String name : stale) {
      if (!inputs.contains(SeparateFiles.real(folder.resolve(name)))) {
        next.remove(name);
      }
    }
    hashes().forEach(next::put);
    recordCommit(next);
    moveAll();
    record = next;
    drafted.clear();
  }

  /** The commit point: a killed process leaves the old files before it, the new ones after it. */
  private void recordCommit(FileRecord next) throws IOException {
    Path draft = drafts.resolve(COMMITTED + ".part");
    beforeChange.run();
    Files.writeString(draft, next.text());
    beforeChange.run();
    OutputFile.move(draft, drafts.resolve(COMMITTED));
  }

  /** Moves the committed files into place; can be repeated after a kill. */
  private void moveAll() throws IOException {
    if (!Files.isRegularFile(drafts.resolve(COMMITTED), LinkOption.NOFOLLOW_LINKS)) {
      throw new IOException("'" + COMMITTED + "' is a link or a folder");
    }
    FileRecord next = FileRecord.read(drafts.resolve(COMMITTED));
    for (String name : next.names()) {
      if (Files.exists(draft(name), LinkOption.NOFOLLOW_LINKS)) {
        Files.createDirectories(folder.resolve(name).getParent());
        beforeChange.run();
        OutputFile.move(draft(name), folder.resolve(name));
      }
    }
    FileRecord before = FileRecord.of(folder);
    for (String name : before.names()) {
      if (!next.names().contains(name) && before.isUnchanged(folder, name)) {
        beforeChange.run();
        Files.delete(folder.resolve(name));
      }
    }
    beforeChange.run();
    OutputFile.move(drafts.resolve(COMMITTED), folder.resolve(FileRecord.NAME));
  }

  /** Deletes uncommitted drafts and releases the lock. */
  @Override
  public synchronized void close() throws IOException {
    if (lock.isOpen()) {
      try (lock) {
        if (!isCommitted(folder)) {
          deleteDrafts();
        }
        Files.delete(drafts.resolve(LOCK));
        Files.delete(drafts);
      } catch (DirectoryNotEmptyException e) {
        // another process has opened the folder already
      } finally {
        Unfinished.remove(this);
      }
    }
  }

  /** Releases the lock and leaves the folder as a killed process would. */
  void release() {
    Unfinished.remove(this);
    Io.run(() -> lock.close());
  }

  private void deleteDrafts() throws IOException {
    try (Stream<Path> files = Files.list(drafts)) {
      for (Path file : files.filter(file -> !file.endsWith(LOCK)).toList()) {
        beforeChange.run();
        Files.delete(file);
      }
    }
  }
}
