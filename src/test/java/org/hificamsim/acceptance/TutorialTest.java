package org.hificamsim.acceptance;

import static java.util.stream.Collectors.joining;
import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.File;
import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.regex.MatchResult;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Runs the tutorials as they are written: files with a title are saved, lines after {@code $} are
 * executed, and the output is compared with that on the page, where {@code ...} stands for
 * anything. Tutorials in Python are tested with the Python package.
 */
class TutorialTest {
  private static final Path PAGES = Cli.ROOT.resolve("docs/tutorials");
  private static final Pattern BLOCK =
      Pattern.compile("(?ms)^```(\\w+)(?: title=\"([^\"]+)\")?\n(.*?)^```$");
  private static final Pattern TYPED =
      Pattern.compile("(?ms)^\\$ ([^\n]+)\n((?:(?!\\$ )[^\n]*\n)*)");

  /** The path of the jars in a checkout, as tutorials write it. */
  private static final String JARS = "'cli/build/install/hificamsim/lib/*'";

  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(
      strings = {
        "first-result",
        "detection-model",
        "detector",
        "floor-plan",
        "plans",
        "own-policy",
        "camsim"
      })
  void tutorialRunsAsWritten(String name) throws Exception {
    Files.createSymbolicLink(folder.resolve("scenarios"), Cli.ROOT.resolve("scenarios"));
    Files.createSymbolicLink(folder.resolve("examples"), Cli.ROOT.resolve("examples"));
    Files.copy(Cli.ROOT.resolve("docs/img/shop.png"), folder.resolve("floor.png"));
    writeLauncher();
    for (MatchResult block : blocks(PAGES.resolve(name + ".md")).toList()) {
      if (block.group(2) != null) {
        Files.writeString(folder.resolve(block.group(2)), block.group(3));
      } else if (block.group(1).equals("console")) {
        for (MatchResult typed : TYPED.matcher(block.group(3)).results().toList()) {
          type(typed.group(1), typed.group(2));
        }
      }
    }
  }

  private static Stream<MatchResult> blocks(Path page) throws IOException {
    return BLOCK.matcher(Files.readString(page)).results();
  }

  private void type(String command, String shown) throws Exception {
    if (command.startsWith("python ")) {
      return;
    }
    boolean compiles = command.contains(JARS);
    assumeTrue(!compiles || classPath().endsWith(".jar"), "classes are not in jars here");
    String line = command.replace(JARS, "\"$TUTORIAL_CLASSES\"");
    ProcessBuilder shell = new ProcessBuilder("sh", "-euc", line).directory(folder.toFile());
    shell.environment().put("TUTORIAL_CLASSES", classPath());
    Process process = shell.redirectError(folder.resolve("errors").toFile()).start();
    String output = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(
        0, process.waitFor(), () -> command + "\n" + output + Cli.text(folder.resolve("errors")));
    if (!shown.isBlank()) {
      assertTrue(pattern(shown).matcher(output).matches(), () -> command + "\n" + output);
    }
  }

  /** Returns the pattern of an output on the page, in which three dots match anything. */
  private static Pattern pattern(String shown) {
    String lines =
        Arrays.stream(shown.strip().split("\\.\\.\\.", -1))
            .map(Pattern::quote)
            .collect(joining(".*"));
    return Pattern.compile(lines + "\\s*", Pattern.DOTALL);
  }

  private void writeLauncher() throws IOException {
    Path script = folder.resolve("hificamsim");
    String java = Path.of(System.getProperty("java.home"), "bin", "java").toString();
    Files.writeString(
        script,
        "#!/bin/sh\nexec '"
            + java
            + "' "
            + String.join(" ", Java.SHORT_LIVED)
            + " '-Dhificamsim.root="
            + Cli.ROOT
            + "' -cp \"$TUTORIAL_CLASSES:${CLASSPATH:-}\" org.hificamsim.cli.Main \"$@\"\n");
    assertTrue(script.toFile().setExecutable(true));
  }

  /** Returns absolute paths, because commands run in another folder. */
  private static String classPath() {
    return Arrays.stream(System.getProperty("java.class.path").split(File.pathSeparator))
        .map(entry -> Path.of(entry).toAbsolutePath().toString())
        .collect(joining(File.pathSeparator));
  }
}
