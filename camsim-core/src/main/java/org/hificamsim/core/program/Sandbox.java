package org.hificamsim.core.program;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.file.Io;

/**
 * Limits what a program may do: its processor time and memory, and, where Linux's namespaces are
 * available, it has no network, sees no other process, and writes to its own folder alone. It can
 * read files.
 *
 * @param seconds of processor time
 * @param megabytes of memory
 */
public record Sandbox(long seconds, int megabytes) {
  /** The program that makes namespaces, as its own messages begin. */
  static final String PROGRAM = "unshare";

  private static final String SCRIPT =
      new String(Io.resource(Sandbox.class, "sandbox.sh"), StandardCharsets.UTF_8);

  /** Starts a program in a folder, with nothing of this process's environment. */
  Process start(List<String> program, Path folder, Path errors) throws IOException {
    List<String> command = new ArrayList<>(List.of("sh", "-c", SCRIPT, "sh"));
    command.add(Long.toString(seconds));
    command.add(Long.toString(1024L * megabytes));
    command.addAll(program);
    ProcessBuilder builder =
        new ProcessBuilder(command).directory(folder.toFile()).redirectError(errors.toFile());
    String path = builder.environment().getOrDefault("PATH", "/usr/bin:/bin");
    builder.environment().clear();
    builder.environment().put("PATH", path);
    builder.environment().put("HOME", folder.toString());
    builder.environment().put("OMP_NUM_THREADS", "1"); // sums are added in the same order
    builder.environment().put("OPENBLAS_NUM_THREADS", "1");
    builder.environment().put("MALLOC_ARENA_MAX", "2"); // each takes 64 MB of addresses
    return builder.start();
  }
}
