package org.hificamsim.core.program;

import java.io.DataInputStream;
import java.io.DataOutputStream;
import java.io.IOException;
import java.nio.file.FileVisitResult;
import java.nio.file.Files;
import java.nio.file.Path;
import java.nio.file.SimpleFileVisitor;
import java.nio.file.attribute.BasicFileAttributes;
import java.util.List;
import java.util.concurrent.CompletableFuture;
import java.util.concurrent.Future;
import java.util.concurrent.TimeUnit;
import org.hificamsim.core.file.Io;

/**
 * A running program in a {@link Sandbox}, with a folder of its own that is deleted at the end.
 * Callers use its input and output; its error output says why it ended.
 */
public final class LimitedProgram implements AutoCloseable {
  private static final String ERRORS = "errors";

  private final Path folder;
  private final Process process;
  private final DataOutputStream out;
  private final DataInputStream in;
  private Future<?> deadline = CompletableFuture.completedFuture(null);

  /**
   * Starts a program.
   *
   * @param folder the program's own folder, in which it runs
   * @param command the words of the command, the first of which is found on the path
   * @throws IOException when the system cannot start it
   */
  public LimitedProgram(Path folder, List<String> command, Sandbox sandbox) throws IOException {
    this(folder, command, sandbox, Sandbox.confines());
  }

  LimitedProgram(Path folder, List<String> command, Sandbox sandbox, boolean confined)
      throws IOException {
    this.folder = folder;
    process = sandbox.start(command, folder, folder.resolve(ERRORS), confined);
    out = new DataOutputStream(process.getOutputStream());
    in = new DataInputStream(process.getInputStream());
  }

  /** The input of the program, which the caller flushes. */
  public DataOutputStream out() {
    return out;
  }

  /** The output of the program. */
  public DataInputStream in() {
    return in;
  }

  /** Waits for the end of the program, and returns its exit code; 1 if interrupted. */
  int exit() {
    try {
      return process.waitFor();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return 1;
    }
  }

  /**
   * Sets a deadline in seconds from now, in place of an earlier one. After that time, the program
   * is ended and reading its output fails.
   */
  public void limit(long seconds) {
    deadline.cancel(false);
    deadline =
        CompletableFuture.runAsync(
            process::destroyForcibly, CompletableFuture.delayedExecutor(seconds, TimeUnit.SECONDS));
  }

  /**
   * The reason why the program ended: the last line of its error output.
   *
   * @param otherwise the reason if the error output is empty, as for a program that was killed
   */
  public String reason(String otherwise) {
    try {
      process.waitFor(1, TimeUnit.SECONDS);
      List<String> lines =
          Files.readAllLines(folder.resolve(ERRORS)).stream()
              .filter(line -> !line.isBlank() && !line.startsWith(Sandbox.PROGRAM))
              .toList();
      return lines.isEmpty() ? otherwise : lines.get(lines.size() - 1);
    } catch (IOException e) {
      return "no reason";
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return "interrupted";
    }
  }

  /** Ends the program and deletes its folder. */
  @Override
  public void close() {
    deadline.cancel(false);
    process.destroyForcibly();
    Io.run(() -> Files.walkFileTree(folder, new Deletion()));
  }

  /** Deletes files and folders; what is gone already, or still used, is left to the system. */
  private static final class Deletion extends SimpleFileVisitor<Path> {
    @Override
    public FileVisitResult visitFile(Path file, BasicFileAttributes attributes) {
      return delete(file);
    }

    @Override
    public FileVisitResult visitFileFailed(Path file, IOException e) {
      return FileVisitResult.CONTINUE;
    }

    @Override
    public FileVisitResult postVisitDirectory(Path folder, IOException e) {
      return delete(folder);
    }

    private static FileVisitResult delete(Path file) {
      file.toFile().delete();
      return FileVisitResult.CONTINUE;
    }
  }
}
