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
 * <p>They are written in a hidden folder inside it. {@link #commit} makes the {@link FileRecord} of
 * the folder as it will be, in one move: from then on the new files are the folder's, and the next
 * process that opens it moves what a killed one left to move. Until then, it stays as it was. Files
 * that no command wrote, or that were changed since, are neither replaced nor removed.
 */
public final class OutputFolder implements Closeable {
  private static final String DRAFTS = ".hificamsim";
  private static final String LOCK = "lock";
  private static final String DECIDED = "commit";

  private final Path folder;
  private final Path drafts;
  private final Runnable act;
  private final FileChannel lock;
  private FileRecord record;
  private final Set<Path> kept = new HashSet<>();
  private final Map<String, String> names = new LinkedHashMap<>();

  /**
   * Makes the folder where it is missing, and ends what a killed process has left to do.
   *
   * @throws InputException when the path is a file, cannot be made, or is in use
   */
  public OutputFolder(Path folder) {
    this(folder, () -> {});
  }

  /**
   * @param act called before each change of what is on the disk
   */
  OutputFolder(Path folder, Runnable act) {
    this.folder = made(folder);
    this.drafts = folder.resolve(DRAFTS);
    this.act = act;
    try {
      lock = locked();
    } catch (FileAlreadyExistsException | NoSuchFileException e) {
      throw inUse(e);
    } catch (IOException e) {
      throw unusable(e);
    }
    try {
      Unfinished.add(this);
      if (isDecided(folder)) {
        moveAll();
      }
      deleteDrafts(); // of a process that was killed
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
   * Ends what a killed process has left to do in a folder that is to be read.
   *
   * @throws InputException when that cannot be done, so that the folder is a mixture
   */
  public static void settle(Path folder) throws IOException {
    if (isDecided(folder)) {
      new OutputFolder(folder).close();
    }
  }

  /** Whether commands have written into a folder, or are about to. */
  public static boolean isOne(Path folder) {
    return Files.exists(folder.resolve(DRAFTS)) || Files.exists(folder.resolve(FileRecord.NAME));
  }

  private static boolean isDecided(Path folder) {
    return Files.exists(folder.resolve(DRAFTS).resolve(DECIDED), LinkOption.NOFOLLOW_LINKS);
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
      throw InputException.of("folder '%s' is not writable, expected a folder that is", folder);
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
      throw InputException.of("'%s' is a link or a file, expected a folder or nothing", drafts);
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

  private InputException unusable(IOException e) {
    return InputException.of(
            "'%s' cannot be used (%s), expected a folder of our own or nothing",
            drafts, e.getMessage())
        .because(e);
  }

  /** Where the files appear. */
  public Path path() {
    return folder;
  }

  /** Where the files are until a commit, if their names have no slash. */
  public Path drafts() {
    return drafts;
  }

  /** Neither replaces nor removes files that the command reads. */
  public void keep(Collection<Path> inputs) {
    inputs.forEach(input -> kept.add(SeparateFiles.real(input)));
  }

  /**
   * Checks that files may be written, before the work that they are made of.
   *
   * @throws InputException when one is an input, or was not written by a command
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
    if (kept.contains(SeparateFiles.real(file))) {
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

  /** A writer (UTF-8), compressed if the name ends in {@code .gz}; to be closed before a commit. */
  public Writer open(String name) throws IOException {
    OutputStream out = stream(name);
    return OutputFile.writer(name.endsWith(".gz") ? new GZIPOutputStream(out, 1 << 16) : out);
  }

  /** A stream for a file of this name; the caller closes it before {@link #commit}. */
  public synchronized OutputStream stream(String name) throws IOException {
    claim(name);
    if (names.put(name, "") != null) {
      Files.deleteIfExists(draft(name)); // of the same command
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

  private Path draft(String name) {
    return drafts.resolve(name.replace("/", "%2F"));
  }

  /** The SHA-256 of each file that is to be committed, by its name. */
  public synchronized Map<String, String> hashes() throws IOException {
    for (Map.Entry<String, String> file : names.entrySet()) {
      if (file.getValue().isEmpty()) {
        file.setValue(Sha256.of(draft(file.getKey())));
      }
    }
    return new TreeMap<>(names);
  }

  /**
   * Moves every file opened into place, and removes what an earlier command left under {@code
   * stale}.
   */
  public synchronized void commit(Collection<String> stale) throws IOException {
    claim(names.keySet());
    FileRecord next = record.copy();
    for (String name : stale) {
      if (!kept.contains(SeparateFiles.real(folder.resolve(name)))) {
        next.remove(name);
      }
    }
    hashes().forEach(next::put);
    decide(next);
    moveAll();
    record = next;
    names.clear();
  }

  /** From here on the folder is the new one, and before it was the old one. */
  private void decide(FileRecord next) throws IOException {
    Path draft = drafts.resolve(DECIDED + ".part");
    act.run();
    Files.writeString(draft, next.text());
    act.run();
    OutputFile.move(draft, drafts.resolve(DECIDED));
  }

  /** Makes the folder what was decided; as often as it takes. */
  private void moveAll() throws IOException {
    if (!Files.isRegularFile(drafts.resolve(DECIDED), LinkOption.NOFOLLOW_LINKS)) {
      throw new IOException("'" + DECIDED + "' is a link or a folder");
    }
    FileRecord next = FileRecord.read(drafts.resolve(DECIDED));
    for (String name : next.names()) {
      if (Files.exists(draft(name), LinkOption.NOFOLLOW_LINKS)) {
        Files.createDirectories(folder.resolve(name).getParent());
        act.run();
        OutputFile.move(draft(name), folder.resolve(name));
      }
    }
    FileRecord before = FileRecord.of(folder);
    for (String name : before.names()) {
      if (!next.names().contains(name) && before.isUnchanged(folder, name)) {
        act.run();
        Files.delete(folder.resolve(name));
      }
    }
    act.run();
    OutputFile.move(drafts.resolve(DECIDED), folder.resolve(FileRecord.NAME));
  }

  /** Removes whatever has not been committed, and lets others use the folder. */
  @Override
  public synchronized void close() throws IOException {
    if (lock.isOpen()) {
      try (lock) {
        if (!isDecided(folder)) {
          deleteDrafts();
        }
        Files.delete(drafts.resolve(LOCK));
        Files.delete(drafts);
      } catch (DirectoryNotEmptyException e) {
        // the next one is in it already
      } finally {
        Unfinished.remove(this);
      }
    }
  }

  /** Lets others use the folder, and leaves it as it is, as a killed process does. */
  void release() {
    Unfinished.remove(this);
    Io.run(() -> lock.close());
  }

  private void deleteDrafts() throws IOException {
    try (Stream<Path> files = Files.list(drafts)) {
      for (Path file : files.filter(file -> !file.endsWith(LOCK)).toList()) {
        act.run();
        Files.delete(file);
      }
    }
  }
}
