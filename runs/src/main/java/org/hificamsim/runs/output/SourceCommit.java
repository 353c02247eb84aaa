package org.hificamsim.runs.output;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Optional;

/** The commit of the checkout that the launcher has built this program from. */
final class SourceCommit {
  private SourceCommit() {}

  /** The commit's name, with {@code -dirty} where files were changed since; empty without Git. */
  static Optional<String> name() {
    return Optional.ofNullable(System.getProperty("hificamsim.root"))
        .map(Path::of)
        .filter(root -> Files.exists(root.resolve(".git")))
        .flatMap(SourceCommit::described);
  }

  private static Optional<String> described(Path root) {
    ProcessBuilder git =
        new ProcessBuilder("git", "describe", "--always", "--dirty", "--abbrev=40", "--exclude=*");
    git.directory(root.toFile()).redirectError(ProcessBuilder.Redirect.DISCARD);
    git.environment().put("GIT_OPTIONAL_LOCKS", "0");
    try {
      Process asked = git.start();
      String said = new String(asked.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
      return asked.waitFor() == 0 ? Optional.of(said.strip()) : Optional.empty();
    } catch (IOException e) {
      return Optional.empty(); // no Git
    } catch (InterruptedException e) {
      Thread.currentThread().interrupt();
      return Optional.empty();
    }
  }
}
