package org.hificamsim.core.program;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.file.Io;

/**
 * Limits what a program may do: its processor time and memory, and, where the system {@link
 * #confines} programs, it has no network, sees no other process, writes to its own folder alone,
 * and reads nothing but that folder, the system's programs and libraries, and what it is given.
 * Folders that are hidden from it are empty.
 *
 * @param seconds the limit of processor time, in seconds
 * @param megabytes the limit of memory, in megabytes
 * @param readable the files and folders that the program may read
 * @param hidden folders among these that it sees as empty ones
 */
public record Sandbox(long seconds, int megabytes, List<Path> readable, List<Path> hidden) {
  /** The name of the program that makes namespaces, with which its own messages begin. */
  static final String PROGRAM = "unshare";

  private static final String SCRIPT =
      new String(Io.resource(Sandbox.class, "sandbox.sh"), StandardCharsets.UTF_8);

  /** Limits for a program that reads only its own folder and files of the system. */
  public Sandbox(long seconds, int megabytes) {
    this(seconds, megabytes, List.of(), List.of());
  }

  /** Whether this system confines programs: Linux does where users may make namespaces. */
  public static boolean confines() {
    return Confinement.AVAILABLE;
  }

  /** Whether confinement works, which is tested once by a program that does nothing. */
  private static final class Confinement {
    private static final boolean AVAILABLE = isAvailable();

    private static boolean isAvailable() {
      Sandbox sandbox = new Sandbox(10, 1_000);
      try (LimitedProgram nothing = new LimitedProgram(folder(), List.of("true"), sandbox, true)) {
        return nothing.exit() == 0;
      } catch (IOException e) {
        return false;
      }
    }

    private static Path folder() throws IOException {
      return Files.createTempDirectory("confined");
    }
  }

  /** The same limits for a program that may read more. */
  public Sandbox reading(List<Path> more) {
    return new Sandbox(
        seconds, megabytes, Stream.concat(readable.stream(), more.stream()).toList(), hidden);
  }

  /** The same limits for a program from which more folders are hidden. */
  public Sandbox hiding(List<Path> more) {
    return new Sandbox(
        seconds, megabytes, readable, Stream.concat(hidden.stream(), more.stream()).toList());
  }

  /** Starts a program in a folder, with nothing of this process's environment. */
  Process start(List<String> program, Path folder, Path errors, boolean confined)
      throws IOException {
    ProcessBuilder builder =
        new ProcessBuilder(command(program, confined))
            .directory(folder.toFile())
            .redirectError(errors.toFile());
    String path = builder.environment().getOrDefault("PATH", "/usr/bin:/bin");
    builder.environment().clear();
    builder.environment().put("PATH", path);
    builder.environment().put("HOME", folder.toString());
    // With one thread, sums are added in the same order.
    builder.environment().put("OMP_NUM_THREADS", "1");
    builder.environment().put("OPENBLAS_NUM_THREADS", "1");
    // Each arena takes 64 MB of addresses.
    builder.environment().put("MALLOC_ARENA_MAX", "2");
    return builder.start();
  }

  private List<String> command(List<String> program, boolean confined) {
    List<String> command = new ArrayList<>(List.of("sh", "-c", SCRIPT, "sh"));
    command.add(confined ? "confined" : "limited");
    command.add(Long.toString(seconds));
    command.add(Long.toString(1024L * megabytes));
    addFolders(command, readable);
    addFolders(command, hidden);
    command.addAll(program);
    return command;
  }

  /** Adds the number of paths, and the paths: a folder before what is in it. */
  private static void addFolders(List<String> command, List<Path> paths) {
    command.add(Integer.toString(paths.size()));
    paths.stream().map(Path::toAbsolutePath).sorted().map(Path::toString).forEach(command::add);
  }
}
