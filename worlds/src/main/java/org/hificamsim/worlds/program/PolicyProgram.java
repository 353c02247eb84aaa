package org.hificamsim.worlds.program;

import java.io.DataInputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.OutputStream;
import java.io.UncheckedIOException;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.DirectoryNotEmptyException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.TimeUnit;
import org.hificamsim.core.InputException;

/** A running program of Python that decides for cameras. */
final class PolicyProgram implements AutoCloseable {
  private static final String PYTHON = "HIFICAMSIM_PYTHON";
  private static final String SCRIPT = "decide.py";
  private static final String COPY = "policy.py";
  private static final String ERRORS = "errors";

  private final Path file;
  private final Path folder;
  private final Process process;
  private final OutputStream out;
  private final DataInputStream in;

  /**
   * Starts the program in a folder of its own, with a copy of the file.
   *
   * @param header a line that says how much it reads and writes
   */
  PolicyProgram(Path file, String header, Sandbox sandbox) {
    this.file = file;
    try {
      folder = Files.createTempDirectory("policy");
      Files.copy(file, folder.resolve(COPY));
      try (InputStream script = PolicyProgram.class.getResourceAsStream(SCRIPT)) {
        Files.copy(script, folder.resolve(SCRIPT));
      }
      String caller = System.getProperty("hificamsim.python", "python3");
      String python = System.getenv().getOrDefault(PYTHON, caller);
      process = sandbox.start(List.of(python, "-I", SCRIPT, COPY), folder, folder.resolve(ERRORS));
      out = process.getOutputStream();
      in = new DataInputStream(process.getInputStream());
      send(header.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new InputException(
          file + " cannot be run (" + e.getMessage() + "), expected python3, or " + PYTHON, e);
    }
  }

  /** Sends what cameras know, and receives their actions. */
  void decide(float[] observations, byte[] masks, int[] actions) {
    ByteBuffer told =
        ByteBuffer.allocate(Float.BYTES * observations.length + masks.length)
            .order(ByteOrder.LITTLE_ENDIAN);
    told.asFloatBuffer().put(observations);
    told.position(Float.BYTES * observations.length).put(masks);
    byte[] answer = new byte[Integer.BYTES * actions.length];
    try {
      send(told.array());
      in.readFully(answer);
    } catch (IOException e) {
      throw new InputException(file + " ended: " + reason(), e);
    }
    ByteBuffer.wrap(answer).order(ByteOrder.LITTLE_ENDIAN).asIntBuffer().get(actions);
  }

  private void send(byte[] data) throws IOException {
    out.write(data);
    out.flush();
  }

  /** The last line that the program wrote to its errors, or how it ended. */
  private String reason() {
    try {
      process.waitFor(1, TimeUnit.SECONDS);
      List<String> lines =
          Files.readAllLines(folder.resolve(ERRORS)).stream()
              .filter(line -> !line.isBlank() && !line.startsWith(Sandbox.PROGRAM))
              .toList();
      return lines.isEmpty()
          ? "out of its processor time or memory, expected less"
          : lines.get(lines.size() - 1);
    } catch (IOException e) {
      return "no reason";
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return "interrupted";
    }
  }

  @Override
  public void close() {
    process.destroyForcibly();
    try {
      for (String name : List.of(COPY, SCRIPT, ERRORS)) {
        Files.deleteIfExists(folder.resolve(name));
      }
      Files.deleteIfExists(folder);
    } catch (DirectoryNotEmptyException e) {
      // The program has left files of its own, which the system's cleaner of temporary files takes.
      return;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
