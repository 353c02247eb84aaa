package org.hificamsim.runs.compare;

import com.fasterxml.jackson.annotation.JsonIgnoreProperties;
import com.fasterxml.jackson.databind.DeserializationFeature;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.ByteBuffer;
import java.nio.DoubleBuffer;
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
  /** The line's JSON but for its first property, a checksum; k_min and scores are compressed. */
  @JsonIgnoreProperties("sum")
  private record Entry(String key, RunResult result, byte[] kMin, byte[] scores) {}

  private static final int SUM = 16; // hexadecimal digits, the first of a SHA-256
  private static final int HEAD = head("").length();
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
    String text = new String(line, StandardCharsets.UTF_8);
    if (text.length() < HEAD || !text.startsWith(head(text.substring(HEAD)))) {
      return Optional.empty();
    }
    try {
      Entry entry = MAPPER.readValue(text, Entry.class);
      int[] kMin = Arrays.stream(unpack(entry.kMin)).mapToInt(value -> (int) value).toArray();
      FinishedRun run = new FinishedRun(entry.result, kMin, unpack(entry.scores));
      return Optional.of(new JournalLine(entry.key, run));
    } catch (IOException e) {
      return Optional.empty();
    }
  }

  /** The line with its end. */
  byte[] line() throws IOException {
    byte[] kMin = pack(Arrays.stream(run.kMin()).asDoubleStream().toArray());
    Entry entry = new Entry(key, run.result(), kMin, pack(run.scores()));
    String rest = MAPPER.writeValueAsString(entry).substring(1);
    return (head(rest) + rest + "\n").getBytes(StandardCharsets.UTF_8);
  }

  /** What stands before the rest of a line. */
  private static String head(String rest) {
    String sum = Sha256.of(rest.getBytes(StandardCharsets.UTF_8)).substring(0, SUM);
    return "{\"sum\":\"" + sum + "\",";
  }

  private static byte[] pack(double[] values) throws IOException {
    ByteArrayOutputStream bytes = new ByteArrayOutputStream();
    try (DataOutputStream out = new DataOutputStream(new DeflaterOutputStream(bytes))) {
      for (double value : values) {
        out.writeDouble(value);
      }
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
