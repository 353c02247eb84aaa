package org.hificamsim.runs.output;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/**
 * The commit of the checkout that the launcher has built this program from. Git looks for it while
 * the program goes on.
 */
final class SourceCommit {
  private final Optional<Process> git;

  private SourceCommit(Optional<Process> git) {
    this.git = git;
  }

  /** Asks Git. */
  static SourceCommit asked() {
    return new SourceCommit(
        Optional.ofNullable(System.getProperty("hificamsim.root"))
            .map(Path::of)
            .filter(root -> Files.exists(root.resolve(".git")))
            .flatMap(SourceCommit::ask));
  }

  private static Optional<Process> ask(Path root) {
    ProcessBuilder git =
        new ProcessBuilder("git", "describe", "--always", "--dirty", "--abbrev=40", "--exclude=*");
    git.directory(root.toFile()).redirectError(ProcessBuilder.Redirect.DISCARD);
    git.environment().put("GIT_OPTIONAL_LOCKS", "0");
    try {
      return Optional.of(git.start());
    } catch (IOException e) {
      return Optional.empty(); // no Git
    }
  }

  /** The commit's name, with {@code -dirty} where files were changed since; empty without Git. */
  Optional<String> name() {
    return git.flatMap(SourceCommit::answer);
  }

  private static Optional<String> answer(Process git) {
    try {
      String said = new String(git.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      return git.waitFor() == 0 ? Optional.of(said.strip()) : Optional.empty();
    } catch (IOException e) {
      return Optional.empty();
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.empty();
    }
  }
}
