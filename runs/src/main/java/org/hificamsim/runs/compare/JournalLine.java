package org.hificamsim.runs.compare;

import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.ByteBuffer;
import java.nio.IntBuffer;
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
  /** The line's JSON; k_min is a count and the values, compressed. */
  private record Entry(String key, RunResult result, byte[] kMin) {}

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
              new JournalLine(entry.key, new FinishedRun(entry.result, unpack(entry.kMin))));
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  /** The line with its end. */
  byte[] line() throws IOException {
    Entry entry = new Entry(key, run.result(), pack(run.kMin()));
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
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (OutputStream out = new DeflaterOutputStream(bytes)) {
      out.write(plain.array());
    }
    return bytes.toByteArray();
  }

  private static int[] unpack(byte[] packed) throws IOException {
    try (InflaterInputStream in = new InflaterInputStream(new ByteArrayInputStream(packed))) {
      IntBuffer ints = ByteBuffer.wrap(in.readAllBytes()).asIntBuffer();
      if (!ints.hasRemaining() || ints.get() != ints.remaining()) {
        throw new IOException("damaged");
      }
      int[] values = new int[ints.remaining()];
      ints.get(values);
      return values;
    }
  }
}
