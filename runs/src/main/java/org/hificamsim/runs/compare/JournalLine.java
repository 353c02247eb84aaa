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
import java.util.Optional;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.InflaterInputStream;
import org.hificamsim.runs.RunResult;

/**
 * A finished run as a line of a journal.
 *
 * @param key of the plan and the seed
 */
record JournalLine(String key, FinishedRun run) {
  /** The line's JSON; k_min is a count and the values, compressed. */
  private record Entry(String key, RunResult result, byte[] kMin) {}

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
    try {
      Entry entry = MAPPER.readValue(line, Entry.class);
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
    return (MAPPER.writeValueAsString(entry) + "\n").getBytes(StandardCharsets.UTF_8);
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
