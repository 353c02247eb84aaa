package org.hificamsim.runs.compare;

import java.io.Closeable;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.Optional;
import org.hificamsim.core.InputException;

/**
 * The finished runs of a comparison that is under way, one line of JSON each, appended as they
 * finish. A process killed while it writes leaves a line without its end: opening the journal drops
 * it, and that run is done again.
 */
final class Journal implements Closeable {
  /** The file's name in the output folder. */
  static final String NAME = ".compare.journal";

  private final Path file;
  private final FileChannel channel;
  private final FinishedRuns found = new FinishedRuns();

  /** Opens the journal of a comparison in a folder. */
  Journal(Path folder, boolean resume) throws IOException {
    this(folder, NAME, resume);
  }

  /**
   * Opens a journal of a folder.
   *
   * @param name the file's
   * @param resume whether runs found there count; otherwise they are dropped
   * @throws InputException when another comparison is at work in the folder
   */
  Journal(Path folder, String name, boolean resume) throws IOException {
    file = folder.resolve(name);
    channel =
        FileChannel.open(
            file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
    if (!locked()) {
      channel.close();
      throw new InputException(
          "--out '" + folder + "': another comparison writes there, expected a folder of its own");
    }
    long whole = resume ? found.read(bytes()) : 0;
    channel.truncate(whole);
    channel.position(whole);
  }

  /** Takes the lock that keeps a second process, or a second comparison in this one, away. */
  private boolean locked() throws IOException {
    try {
      return channel.tryLock() != null;
    } catch (OverlappingFileLockException e) {
      return false;
    }
  }

  /** Read through the channel: closing another handle of the file would give up the lock. */
  private byte[] bytes() throws IOException {
    ByteBuffer bytes = ByteBuffer.allocate(Math.toIntExact(channel.size()));
    while (bytes.hasRemaining() && channel.read(bytes) >= 0) {
      // until all is read
    }
    return bytes.array();
  }

  /** The result of a run that was finished before. */
  synchronized Optional<Outcome> find(String key, long seed) throws IOException {
    return found.find(key, seed);
  }

  /** Appends a finished run, in one write. */
  synchronized void add(String key, long seed, Outcome outcome) throws IOException {
    ByteBuffer line = ByteBuffer.wrap(FinishedRuns.line(key, seed, outcome));
    while (line.hasRemaining()) {
      channel.write(line);
    }
  }

  /** Removes the journal, once the results are in their place. */
  void finish() throws IOException {
    close();
    Files.deleteIfExists(file);
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }
}
