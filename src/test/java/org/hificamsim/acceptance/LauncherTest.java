package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import org.hificamsim.cli.Main;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.ValueSource;

/**
 * Tests how {@code tools/setup.sh} handles locales and paths before the command line starts, and
 * which options {@code ./hificamsim} passes to the JVM.
 */
class LauncherTest {
  private static final String SOURCE = ". '" + Cli.ROOT.resolve("tools/setup.sh") + "'\n";
  private static final String JAVA = System.getProperty("java.home") + "/bin/java";

  @TempDir Path folder;

  @ParameterizedTest
  @ValueSource(strings = {"C", "C.UTF-8"})
  void acceptsAccentedFileNamesInEveryLocale(String locale) throws Exception {
    Files.copy(Cli.scenario("ring-random"), folder.resolve("plain.xml"));
    String script =
        "root=$PWD\n"
            + SOURCE
            + "name=$(printf 'caf\\303\\251'); mv plain.xml $name.xml\n"
            + JAVA
            + " org.hificamsim.cli.Main run $name.xml --steps 5\n"
            + "mv out/$name plain\n";
    String output = shell(script, Map.of("LC_ALL", locale));
    Path summary = folder.resolve("plain/summary.json");
    assertTrue(Files.exists(summary), output);
    assertTrue(Files.readString(summary).contains("\"caf\u00e9\""));
  }

  /** The command line is not on the class path, but in a folder whose name has an accent. */
  @ParameterizedTest
  @ValueSource(strings = {"C", "C.UTF-8"})
  void startsInAccentedFolderInEveryLocale(String locale) throws Exception {
    Path jar = Path.of(Main.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    String others = System.getProperty("java.class.path").replace(jar.toString(), "none");
    String script =
        "root=$PWD\n"
            + SOURCE
            + "home=$(printf 'caf\\303\\251'); mkdir $home; cp '%s' $home/cli.jar\n".formatted(jar)
            + JAVA
            + " -cp $home/cli.jar:$CLASSPATH org.hificamsim.cli.Main help\n";
    String output = shell(script, Map.of("LC_ALL", locale, "CLASSPATH", others));
    assertTrue(output.startsWith("Usage: hificamsim"), output);
  }

  @Test
  void rejectsFolderWithColonInOneLine() throws Exception {
    assertEquals(
        "hificamsim: this folder is /a:b, expected a path without a colon: Java's class path"
            + " cannot hold one\n",
        shell("root=/a:b\n" + SOURCE + "echo not reached\n", Map.of()));
  }

  @Test
  void rejectsTooFewOpenFilesBeforeJavaStarts() throws Exception {
    assertEquals(
        "error: at most 64 files may be open (ulimit -n), expected 128 or more\n2\n",
        shell("ulimit -n 64\nsh '" + Cli.ROOT.resolve("hificamsim") + "' list; echo $?", Map.of()));
  }

  /** The launcher runs with a JVM that prints its options. */
  @Test
  void onlyCamsimAndViewLimitYoungObjects() throws Exception {
    Files.createDirectories(folder.resolve("tools"));
    Files.createDirectories(folder.resolve("bin"));
    for (String part : List.of("hificamsim", "tools/parts.sh", "tools/start.sh")) {
      Files.copy(Cli.ROOT.resolve(part), folder.resolve(part));
    }
    Files.writeString(
        folder.resolve("tools/setup.sh"),
        "build_if_stale() { :; }; run_home() { echo \"$root\"; }; lib=lib; archive=none\n");
    Files.writeString(folder.resolve("bin/java"), "#!/bin/sh\necho \"$*\"\n");
    String script = "chmod +x bin/java; sh hificamsim %s x.xml\n";
    Map<String, String> own = Map.of("HIFICAMSIM_OPTS", "-XX:MaxNewSize=1m");
    String camsim = shell(script.formatted("camsim"), own);
    int bound = camsim.indexOf("-XX:MaxNewSize=96m");
    assertTrue(bound > 0 && bound < camsim.indexOf("-XX:MaxNewSize=1m"), camsim);
    assertFalse(shell(script.formatted("run"), own).contains("96m"));
  }

  private String shell(String script, Map<String, String> environment)
      throws IOException, InterruptedException {
    ProcessBuilder shell = new ProcessBuilder("sh", "-c", script);
    shell.directory(folder.toFile()).redirectErrorStream(true);
    shell.environment().put("CLASSPATH", System.getProperty("java.class.path"));
    shell.environment().putAll(environment);
    Process process = shell.start();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    process.waitFor();
    return text;
  }
}
