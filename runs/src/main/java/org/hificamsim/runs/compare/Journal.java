package org.hificamsim.runs.compare;

import static org.hificamsim.core.NamedSetting.setting;

import com.fasterxml.jackson.annotation.JsonIgnoreProperties;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.Closeable;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.DoubleBuffer;
import java.nio.channels.FileChannel;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.LinkOption;
import java.nio.file.Path;
import java.nio.file.StandardOpenOption;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.InflaterInputStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.file.Sha256;
import org.hificamsim.runs.RunResult;

/**
 * Keeps finished runs in a file, so that an interrupted comparison can be resumed. Each run is a
 * line of JSON with a checksum, which is appended when the run finishes. An incomplete last line,
 * left by a killed process, is dropped; damaged lines are counted. The runs of such lines are
 * computed again, but the lines stay.
 *
 * <p>The journal of a comparison is deleted when its results are in place; the journal of a shard
 * is the shard's result. A journal finds only the runs that it had when it was opened, and not
 * those that are added later: {@link JournalledEngine} skips the former.
 */
public final class Journal implements Closeable {
  /** The name of the file in the folder of a comparison. */
  public static final String COMPARISON_FILE = ".compare.journal";

  /** The name of the file in the folder of a shard. */
  private static final String SHARD_FILE = "runs.jsonl";

  /** The start of each line, which distinguishes a journal from other files. */
  private static final byte[] BEGIN = "{\"sum\":\"".getBytes(StandardCharsets.UTF_8);

  private static final int MAX_LINE_BYTES = 1 << 28;
  private static final int CHUNK_BYTES = 1 << 16;

  /** The position of a line in the file, in bytes. */
  private record Line(long start, int length) {}

  private final Path file;
  private final FileChannel channel;

  /** The last line of each run when the journal was opened, by the plan's key with the seed. */
  private final Map<String, Line> lines = new HashMap<>();

  private final List<Integer> damagedLines = new ArrayList<>();
  private int lineCount;

  private Journal(Path file, FileChannel channel) {
    this.file = file;
    this.channel = channel;
  }

  /**
   * Opens a journal for adding runs.
   *
   * @param folder the folder, which stays open for as long as the journal
   * @param name the name of the file
   * @param resume whether runs in it are kept; otherwise they are dropped
   * @throws InputException when the file is a link
   */
  public static Journal open(OutputFolder folder, String name, boolean resume) throws IOException {
    Path file = folder.path().resolve(name);
    if (Files.isSymbolicLink(file)) {
      throw new InputException("'" + file + "' is a link, expected a file or nothing");
    }
    FileChannel channel =
        FileChannel.open(
            file,
            StandardOpenOption.CREATE,
            StandardOpenOption.READ,
            StandardOpenOption.WRITE,
            LinkOption.NOFOLLOW_LINKS);
    Journal journal = new Journal(file, channel);
    long end = resume ? journal.index() : 0;
    channel.truncate(end); // drops an incomplete last line, or all lines
    channel.position(end);
    return journal;
  }

  /**
   * Opens the journal of a shard for adding runs.
   *
   * @param resume whether runs in it are kept; otherwise the file must not exist
   * @throws InputException when the file exists and may not, or is not a journal
   */
  public static Journal ofShard(OutputFolder folder, boolean resume) throws IOException {
    Path file = folder.path().resolve(SHARD_FILE);
    if (!resume && Files.exists(file, LinkOption.NOFOLLOW_LINKS)) {
      throw InputException.of(
          "'%s' would be replaced: expected another folder, or %s to keep its runs",
          file, setting("resume"));
    }
    if (Files.isRegularFile(file, LinkOption.NOFOLLOW_LINKS) && !isJournal(file)) {
      throw InputException.of(
          "'%s' would be replaced, and no shard wrote it: expected another folder", file);
    }
    return open(folder, SHARD_FILE, resume);
  }

  /** Whether a file begins like a journal; a killed command may have left only part of a line. */
  private static boolean isJournal(Path file) throws IOException {
    try (InputStream in = Files.newInputStream(file)) {
      byte[] found = in.readNBytes(BEGIN.length);
      return Arrays.equals(found, Arrays.copyOf(BEGIN, found.length));
    }
  }

  /**
   * Opens the journal of a shard for reading.
   *
   * @throws InputException when it is missing
   */
  static Journal ofShard(Path folder) throws IOException {
    Path file = folder.resolve(SHARD_FILE);
    if (!Files.isRegularFile(file)) {
      throw InputException.of("no file '%s', expected what %s writes", file, setting("shard"));
    }
    Journal journal = new Journal(file, FileChannel.open(file));
    journal.index();
    return journal;
  }

  /** Finds the line of each run, and returns where the last line ends. */
  private long index() throws IOException {
    ByteBuffer chunk = ByteBuffer.allocate(CHUNK_BYTES);
    long start = 0;
    for (long offset = 0; channel.read(chunk.clear(), offset) > 0; offset += chunk.position()) {
      for (int i = 0; i < chunk.position(); i++) {
        if (chunk.get(i) == '\n') {
          index(start, offset + i);
          start = offset + i + 1;
        }
      }
    }
    return start;
  }

  private void index(long start, long end) throws IOException {
    lineCount++;
    Line line = new Line(start, (int) Math.min(MAX_LINE_BYTES, end - start));
    Optional<JournalLine> run = JournalLine.parse(bytes(line));
    run.ifPresentOrElse(parsed -> lines.put(parsed.key(), line), () -> damagedLines.add(lineCount));
  }

  /** A message about the damaged lines; empty if there are none. */
  public Optional<String> damage() {
    return damagedLines.isEmpty()
        ? Optional.empty()
        : Optional.of(
            Texts.format(
                "%s:%s: the line is damaged%s",
                file,
                damagedLines.get(0),
                damagedLines.size() == 1
                    ? ""
                    : ", and " + (damagedLines.size() - 1) + " more are"));
  }

  private byte[] bytes(Line line) throws IOException {
    ByteBuffer bytes = ByteBuffer.allocate(line.length);
    while (bytes.hasRemaining() && channel.read(bytes, line.start + bytes.position()) >= 0) {
      // until all is read
    }
    return bytes.array();
  }

  /**
   * Whether the journal had a run when it was opened.
   *
   * @param key the {@link RunKey#text} of its plan
   */
  boolean has(String key, long seed) {
    return lines.containsKey(JournalLine.key(key, seed));
  }

  /**
   * Checks that the journal has no runs of an input that a comparison has under the same name with
   * another content. Runs of inputs with other names, or with other settings, are allowed; they are
   * never found.
   *
   * @throws InputException naming an input that has changed under the same name
   */
  void requireUnchanged(List<RunKey> keys) {
    lines.keySet().stream()
        .map(JournalLine::planKey)
        .distinct()
        .map(RunKey::read)
        .flatMap(found -> keys.stream().flatMap(key -> key.changed(found).stream()))
        .findFirst()
        .ifPresent(
            input -> {
              throw InputException.of(
                  "'%s' has runs of another %s, expected the same to %s or %s; without %s, all"
                      + " runs are done again",
                  file, input, setting("merge"), setting("resume"), setting("resume"));
            });
  }

  /**
   * A run that the journal had when it was opened; empty if it had no such run.
   *
   * @param key the {@link RunKey#text} of its plan
   */
  synchronized Optional<FinishedRun> find(String key, long seed) throws IOException {
    Line line = lines.get(JournalLine.key(key, seed));
    return line == null ? Optional.empty() : JournalLine.parse(bytes(line)).map(JournalLine::run);
  }

  /**
   * Appends a finished run, which is found when the journal is opened again.
   *
   * @param key the {@link RunKey#text} of its plan
   */
  synchronized void add(String key, long seed, FinishedRun run) throws IOException {
    ByteBuffer line = ByteBuffer.wrap(new JournalLine(JournalLine.key(key, seed), run).bytes());
    while (line.hasRemaining()) {
      channel.write(line);
    }
  }

  /** Deletes the journal when the results are in place. */
  public void finish() throws IOException {
    close();
    Files.deleteIfExists(file);
  }

  @Override
  public void close() throws IOException {
    channel.close();
  }

  /**
   * A line of a journal: a finished run.
   *
   * @param key made of the plan's key and the seed
   */
  private record JournalLine(String key, FinishedRun run) {
    /** The JSON of a line without its first property, the checksum; arrays are compressed. */
    @JsonIgnoreProperties("sum")
    private record Entry(String key, RunResult result, byte[] kMin, byte[] scores) {}

    /** The number of hexadecimal digits of a SHA-256 that make the checksum. */
    private static final int CHECKSUM_DIGITS = 16;

    private static final int HEAD_LENGTH = head(new byte[0]).length();
    private static final ObjectMapper MAPPER =
        new ObjectMapper()
            .enable(DeserializationFeature.FAIL_ON_MISSING_CREATOR_PROPERTIES)
            .enable(DeserializationFeature.FAIL_ON_NULL_CREATOR_PROPERTIES)
            .enable(DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES);

    static String key(String planKey, long seed) {
      return planKey + "/" + seed;
    }

    /** The plan's key within the key of a run. */
    static String planKey(String key) {
      return key.substring(0, Math.max(0, key.lastIndexOf('/')));
    }

    /** Reads a line; empty if it is damaged. */
    static Optional<JournalLine> parse(byte[] line) {
      byte[] rest = Arrays.copyOfRange(line, Math.min(HEAD_LENGTH, line.length), line.length);
      String head = new String(line, 0, line.length - rest.length, StandardCharsets.UTF_8);
      if (!head.equals(head(rest))) {
        return Optional.empty();
      }
      try {
        Entry entry = MAPPER.readValue(line, Entry.class);
        int[] kMin = Arrays.stream(unpack(entry.kMin)).mapToInt(value -> (int) value).toArray();
        FinishedRun run = new FinishedRun(entry.result, kMin, unpack(entry.scores));
        return Optional.of(new JournalLine(entry.key, run));
      } catch (IOException e) {
        return Optional.empty();
      }
    }

    /** The line as bytes, with its line end. */
    byte[] bytes() throws IOException {
      byte[] kMin = pack(Arrays.stream(run.kMin()).asDoubleStream().toArray());
      Entry entry = new Entry(key, run.result(), kMin, pack(run.scores()));
      byte[] text = MAPPER.writeValueAsBytes(entry);
      byte[] rest = Arrays.copyOfRange(text, 1, text.length);
      ByteArrayOutputStream line = new ByteArrayOutputStream();
      line.writeBytes(head(rest).getBytes(StandardCharsets.UTF_8));
      line.writeBytes(rest);
      line.write('\n');
      return line.toByteArray();
    }

    /** The beginning of a line: the checksum of the rest. */
    private static String head(byte[] rest) {
      String sum = Sha256.of(rest).substring(0, CHECKSUM_DIGITS);
      return "{\"sum\":\"" + sum + "\",";
    }

    private static byte[] pack(double[] values) throws IOException {
      ByteBuffer plain = ByteBuffer.allocate(values.length * Double.BYTES);
      plain.asDoubleBuffer().put(values);
      ByteArrayOutputStream bytes = new ByteArrayOutputStream();
      try (OutputStream out = new DeflaterOutputStream(bytes)) {
        out.write(plain.array());
      }
      return bytes.toByteArray();
    }

    private static double[] unpack(byte[] packed) throws IOException {
      try (InflaterInputStream in = new InflaterInputStream(new ByteArrayInputStream(packed))) {
        DoubleBuffer plain = ByteBuffer.wrap(in.readAllBytes()).asDoubleBuffer();
        double[] values = new double[plain.remaining()];
        plain.get(values);
        return values;
      }
    }
  }
}
