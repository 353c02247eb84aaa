package org.hificamsim.runs.compare;

import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.charset.StandardCharsets;
import java.util.Arrays;
import java.util.Optional;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.InflaterInputStream;
import org.hificamsim.core.file.Sha256;
import org.hificamsim.runs.RunResult;

/**
 * A finished run as a line of a journal.
 *
 * @param key of the plan and the seed
 */
record JournalLine(String key, FinishedRun run) {
  /** The line's JSON; k_min and scores are each a count and the values, compressed. */
  private record Entry(String key, RunResult result, byte[] kMin, byte[] scores) {}

  private static final String START = "{\"sum\":\"";
  private static final String END = "\",";
  private static final int SUM = 16; // hexadecimal digits, the first of a SHA-256

  private static final ObjectMapper MAPPER =
      new ObjectMapper()
          .enable(DeserializationFeature.FAIL_ON_MISSING_CREATOR_PROPERTIES)
          .enable(DeserializationFeature.FAIL_ON_NULL_CREATOR_PROPERTIES)
          .enable(DeserializationFeature.FAIL_ON_NULL_FOR_PRIMITIVES);

  static String key(String plan, long seed) {
    return plan + "/" + seed;
  }

  /** The plan's part of a key. */
  static String plan(String key) {
    return key.substring(0, Math.max(0, key.lastIndexOf('/')));
  }

  /** The run in a line; empty where it is damaged. */
  static Optional<JournalLine> parse(byte[] line) {
    int head = START.length() + SUM + END.length();
    byte[] rest = Arrays.copyOfRange(line, Math.min(head, line.length), line.length);
    if (!Arrays.equals(head(rest), 0, head, line, 0, Math.min(head, line.length))) {
      return Optional.empty();
    }
    try {
      Entry entry = MAPPER.readValue(joined(new byte[] {'{'}, rest), Entry.class);
      return entry == null
          ? Optional.empty()
          : Optional.of(
              new JournalLine(
                  entry.key,
                  new FinishedRun(
                      entry.result, ints(unpack(entry.kMin)), doubles(unpack(entry.scores)))));
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  /** The line with its end. */
  byte[] line() throws IOException {
    Entry entry = new Entry(key, run.result(), pack(run.kMin()), pack(run.scores()));
    byte[] text = MAPPER.writeValueAsBytes(entry);
    byte[] rest = Arrays.copyOfRange(text, 1, text.length);
    return joined(head(rest), rest, new byte[] {'\n'});
  }

  /** What stands before the rest of a line: its checksum, as the JSON's first property. */
  private static byte[] head(byte[] rest) {
    String sum = Sha256.of(rest).substring(0, SUM);
    return (START + sum + END).getBytes(StandardCharsets.UTF_8);
  }

  private static byte[] joined(byte[]... parts) {
    ByteArrayOutputStream all = new ByteArrayOutputStream();
    for (byte[] part : parts) {
      all.writeBytes(part);
    }
    return all.toByteArray();
  }

  private static byte[] pack(int[] values) throws IOException {
    ByteBuffer plain = ByteBuffer.allocate((values.length + 1) * Integer.BYTES);
    plain.asIntBuffer().put(values.length).put(values);
    return compressed(plain.array());
  }

  private static byte[] pack(double[] values) throws IOException {
    ByteBuffer plain = ByteBuffer.allocate(Integer.BYTES + values.length * Double.BYTES);
    plain.putInt(values.length).asDoubleBuffer().put(values);
    return compressed(plain.array());
  }

  private static byte[] compressed(byte[] plain) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (OutputStream out = new DeflaterOutputStream(bytes)) {
      out.write(plain);
    }
    return bytes.toByteArray();
  }

  private static ByteBuffer unpack(byte[] packed) throws IOException {
    try (InflaterInputStream in = new InflaterInputStream(new ByteArrayInputStream(packed))) {
      return ByteBuffer.wrap(in.readAllBytes());
    }
  }

  private static int[] ints(ByteBuffer plain) throws IOException {
    int[] values = new int[count(plain, Integer.BYTES)];
    plain.asIntBuffer().get(values);
    return values;
  }

  private static double[] doubles(ByteBuffer plain) throws IOException {
    double[] values = new double[count(plain, Double.BYTES)];
    plain.asDoubleBuffer().get(values);
    return values;
  }

  /** How many values there are, if that is what is said. */
  private static int count(ByteBuffer plain, int bytes) throws IOException {
    if (plain.remaining() < Integer.BYTES || (long) plain.getInt() * bytes != plain.remaining()) {
      throw new IOException("damaged");
    }
    return plain.remaining() / bytes;
  }
}
