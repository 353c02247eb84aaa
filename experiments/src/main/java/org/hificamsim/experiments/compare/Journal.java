package org.hificamsim.experiments.compare;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.channels.FileChannel;
import java.nio.channels.OverlappingFileLockException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.InflaterInputStream;
import org.hificamsim.core.InputException;
import org.hificamsim.experiments.run.RunResult;

/**
 * The finished runs of a comparison that is under way, one line of JSON each, appended as they
 * finish. A process killed while it writes leaves a line without its end: opening the journal drops
 * it, and that run is done again.
 */
final class Journal implements Closeable {
  /** The file's name in the output folder. */
  static final String NAME = ".compare.journal";

  private record Entry(String key, RunResult result, byte[] kMin) {}

  private final Path file;
  private final FileChannel channel;
  private final ObjectMapper mapper = new ObjectMapper();
  private final Map<String, Entry> done = new HashMap<>();

  /**
   * Opens the journal of a folder.
   *
   * @param resume whether runs found there count; otherwise they are dropped
   * @throws InputException when another comparison is at work in the folder
   */
  Journal(Path folder, boolean resume) throws IOException {
    file = folder.resolve(NAME);
    channel =
        FileChannel.open(
            file, StandardOpenOption.CREATE, StandardOpenOption.READ, StandardOpenOption.WRITE);
    if (!locked()) {
      channel.close();
      throw new InputException(
          "--out '" + folder + "': another comparison writes there, expected a folder of its own");
    }
    long whole = resume ? read(bytes()) : 0;
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
    Entry entry = done.get(name(key, seed));
    return entry == null
        ? Optional.empty()
        : Optional.of(new Outcome(entry.result(), unpack(entry.kMin())));
  }

  /** Appends a finished run, in one write. */
  synchronized void add(String key, long seed, Outcome outcome) throws IOException {
    Entry entry = new Entry(name(key, seed), outcome.result(), pack(outcome.kMin()));
    ByteBuffer line =
        ByteBuffer.wrap((mapper.writeValueAsString(entry) + "\n").getBytes(StandardCharsets.UTF_8));
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

  /** Takes every whole line and returns how many bytes those are. */
  private long read(byte[] bytes) {
    int start = 0;
    for (int i = 0; i < bytes.length; i++) {
      if (bytes[i] == '\n') {
        try {
          Entry entry =
              mapper.readValue(
                  new String(bytes, start, i - start, StandardCharsets.UTF_8), Entry.class);
          done.put(entry.key(), entry);
        } catch (JsonProcessingException e) {
          return start;
        }
        start = i + 1;
      }
    }
    return start;
  }

  private static String name(String key, long seed) {
    return key + "/" + seed;
  }

  private static byte[] pack(int[] values) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (DataOutputStream out = new DataOutputStream(new DeflaterOutputStream(bytes))) {
      out.writeInt(values.length);
      for (int value : values) {
        out.writeInt(value);
      }
    }
    return bytes.toByteArray();
  }

  private static int[] unpack(byte[] packed) throws IOException {
    try (DataInputStream in =
        new DataInputStream(new InflaterInputStream(new ByteArrayInputStream(packed)))) {
      int[] values = new int[in.readInt()];
      for (int i = 0; i < values.length; i++) {
        values[i] = in.readInt();
      }
      return values;
    }
  }
}
