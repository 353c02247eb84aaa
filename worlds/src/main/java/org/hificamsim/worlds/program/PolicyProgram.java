package org.hificamsim.worlds.program;

import java.io.IOException;
import java.io.InputStream;
import java.nio.ByteBuffer;
import java.nio.ByteOrder;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.InputException;
import org.hificamsim.core.program.LimitedProgram;
import org.hificamsim.core.program.PythonInterpreter;
import org.hificamsim.core.program.Sandbox;

/** A running Python program that decides for cameras. */
final class PolicyProgram implements AutoCloseable {
  private static final String SCRIPT = "decide.py";
  private static final String COPY = "policy.py";
  private static final String LIMIT_EXCEEDED = "out of its processor time or memory, expected less";

  private final Path file;
  private final LimitedProgram program;

  /**
   * Starts the program in a folder of its own, with a copy of the policy.
   *
   * @param files the policy, and the weights that it reads if it has any
   * @param header a line with the sizes of the arrays that the program reads and writes
   */
  PolicyProgram(List<Path> files, String header, Sandbox sandbox) {
    file = files.get(0);
    try {
      Path folder = Files.createTempDirectory("policy");
      Files.copy(file, folder.resolve(COPY));
      try (InputStream script = PolicyProgram.class.getResourceAsStream(SCRIPT)) {
        Files.copy(script, folder.resolve(SCRIPT));
      }
      PythonInterpreter python = PythonInterpreter.find();
      List<String> command =
          new ArrayList<>(List.of(python.executable().toString(), "-I", SCRIPT, COPY));
      files.forEach(original -> command.add(original.toAbsolutePath().toString()));
      List<Path> readable = new ArrayList<>(python.folders());
      readable.add(file.toAbsolutePath().getParent());
      readable.addAll(files);
      program =
          new LimitedProgram(folder, command, sandbox.reading(readable).hiding(python.simulator()));
      send(header.getBytes(StandardCharsets.UTF_8));
    } catch (IOException e) {
      throw new InputException(
          "%s cannot be run (%s), expected python3, or %s"
              .formatted(file, e.getMessage(), PythonInterpreter.VARIABLE),
          e);
    }
  }

  /** Sends the observations and masks of cameras, and receives their actions. */
  void decide(float[] observations, byte[] masks, int[] actions) {
    ByteBuffer request =
        ByteBuffer.allocate(Float.BYTES * observations.length + masks.length)
            .order(ByteOrder.LITTLE_ENDIAN);
    request.asFloatBuffer().put(observations);
    request.position(Float.BYTES * observations.length).put(masks);
    byte[] answer = new byte[Integer.BYTES * actions.length];
    try {
      send(request.array());
      program.in().readFully(answer);
    } catch (IOException e) {
      throw new InputException(file + " ended: " + program.reason(LIMIT_EXCEEDED), e);
    }
    ByteBuffer.wrap(answer).order(ByteOrder.LITTLE_ENDIAN).asIntBuffer().get(actions);
  }

  private void send(byte[] data) throws IOException {
    program.out().write(data);
    program.out().flush();
  }

  @Override
  public void close() {
    program.close();
  }
}
