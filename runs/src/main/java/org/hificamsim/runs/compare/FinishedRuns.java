package org.hificamsim.runs.compare;

import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.io.ByteArrayInputStream;
import java.io.ByteArrayOutputStream;
import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import java.util.zip.DeflaterOutputStream;
import java.util.zip.InflaterInputStream;
import org.hificamsim.runs.RunResult;

/** Finished runs as a journal holds them: one line of JSON each, found by key and seed. */
final class FinishedRuns {
  private record Entry(String key, RunResult result, byte[] kMin) {}

  private static final ObjectMapper MAPPER = new ObjectMapper();

  private final Map<String, Entry> done = new HashMap<>();

  /** Takes every whole line, up to one that is none, and returns how many bytes those are. */
  long read(byte[] bytes) {
    int start = 0;
    for (int i = 0; i < bytes.length; i++) {
      if (bytes[i] == '\n') {
        try {
          Entry entry =
              MAPPER.readValue(
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

  /** The result of a run that was finished before. */
  Optional<Outcome> find(String key, long seed) throws IOException {
    Entry entry = done.get(name(key, seed));
    return entry == null
        ? Optional.empty()
        : Optional.of(new Outcome(entry.result(), unpack(entry.kMin())));
  }

  /** Whether a run was finished before. */
  boolean has(String key, long seed) {
    return done.containsKey(name(key, seed));
  }

  /** A finished run as a line with its end. */
  static byte[] line(String key, long seed, Outcome outcome) throws IOException {
    Entry entry = new Entry(name(key, seed), outcome.result(), pack(outcome.kMin()));
    return (MAPPER.writeValueAsString(entry) + "\n").getBytes(StandardCharsets.UTF_8);
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
