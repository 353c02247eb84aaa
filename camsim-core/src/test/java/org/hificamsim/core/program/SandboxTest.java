package org.hificamsim.core.program;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;

/** Tests what programs in a sandbox can do. */
class SandboxTest {
  @TempDir Path folder;

  @Test
  void confinedProgramReadsOnlyWhatItIsGiven() throws IOException {
    assumeTrue(Sandbox.confines(), "this system has no namespaces for users");
    Path given = Files.createDirectory(folder.resolve("a folder with spaces"));
    Files.writeString(given.resolve("note"), "given");
    Files.writeString(folder.resolve("secret"), "secret");
    assertEquals("given\n", run("cat '" + given + "/note'; echo", List.of(given)));
    assertEquals("no\n", run("test -e '" + folder + "/secret' || echo no", List.of(given)));
    assertEquals("no\n", run("touch '" + given + "/new' || echo no", List.of(given)));
    assertFalse(Files.exists(given.resolve("new")));
  }

  @Test
  void hiddenFolderIsEmptyForConfinedProgram() throws IOException {
    assumeTrue(Sandbox.confines(), "this system has no namespaces for users");
    Path hidden = Files.createDirectories(folder.resolve("packages/a folder with jars"));
    Files.writeString(hidden.resolve("oracle"), "truth");
    Path packages = Files.writeString(folder.resolve("packages/library"), "shown").getParent();
    Sandbox sandbox =
        new Sandbox(10, 1_000)
            .reading(List.of(packages))
            .hiding(List.of(hidden, folder.resolve("no folder")));
    String script =
        "cat '" + packages + "/library'; ls -A '" + hidden + "'; echo .; true 2>/dev/null >'";
    assertEquals("shown.\n", said(script + hidden + "/new' || true", sandbox, true));
    assertEquals("truth", Files.readString(hidden.resolve("oracle")));
    assertFalse(Files.exists(hidden.resolve("new")));
  }

  @Test
  void confinedProgramConfinesAnother() throws IOException {
    assumeTrue(Sandbox.confines(), "this system has no namespaces for users");
    assertEquals("free\n", run("unshare -Urm true && echo free", List.of()));
  }

  @Test
  void programWritesToItsOwnFolder() throws IOException {
    assertEquals("kept\n", run("echo kept >file && cat file", List.of()));
  }

  @Test
  void limitedProgramReadsAllFiles() throws IOException {
    Path secret = Files.writeString(folder.resolve("secret"), "open");
    Sandbox sandbox = new Sandbox(10, 1_000);
    assertEquals("open\n", said("cat '" + secret + "'; echo", sandbox, false));
  }

  private String run(String script, List<Path> readable) throws IOException {
    return said(script, new Sandbox(10, 1_000).reading(readable), Sandbox.confines());
  }

  private String said(String script, Sandbox sandbox, boolean confined) throws IOException {
    Path own = Files.createTempDirectory(folder, "own");
    List<String> command = List.of("sh", "-c", script);
    try (LimitedProgram program = new LimitedProgram(own, command, sandbox, confined)) {
      return new String(program.in().readAllBytes(), StandardCharsets.UTF_8);
    }
  }
}
