package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;
import static org.junit.jupiter.api.Assumptions.assumeTrue;

import java.io.IOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.junit.jupiter.api.Test;
import org.junit.jupiter.api.io.TempDir;
import picocli.CommandLine;

/** What the build does to picocli's jar, so that the command line starts sooner. */
class NewerClassesTest {
  private static final Path JAVA_HOME = Path.of(System.getProperty("java.home"));
  private static final Path SOURCE = Cli.ROOT.resolve("cli/src/install/NewerClasses.java");

  @TempDir Path folder;

  @Test
  void classesTooOldForAnArchiveOfClassesAreInItAndDoTheSame() throws Exception {
    assumeTrue(Files.exists(JAVA_HOME.resolve("lib/server/classes.jsa")), "no archive to add to");
    Path old =
        Path.of(CommandLine.class.getProtectionDomain().getCodeSource().getLocation().toURI());
    Path jar = Files.copy(old, folder.resolve("picocli.jar"));
    String asm = "java.base/jdk.internal.org.objectweb.asm=ALL-UNNAMED";
    assertEquals("", java("--add-exports", asm, SOURCE.toString(), jar.toString()));
    String archive = folder.resolve("picocli.jsa").toString();
    Path loaded = folder.resolve("loaded.txt");
    String help = help(old);
    assertTrue(help.contains("Usage:"), help);
    assertEquals(help, help(jar, "-Xlog:disable", "-XX:ArchiveClassesAtExit=" + archive));
    assertEquals(
        help, help(jar, "-XX:SharedArchiveFile=" + archive, "-Xlog:class+load:file=" + loaded));
    assertTrue(
        Files.readString(loaded).contains("picocli.CommandLine source: shared objects file"));
  }

  private static String help(Path jar, String... options) throws IOException, InterruptedException {
    List<String> words = new ArrayList<>(List.of(options));
    words.addAll(List.of("-cp", jar.toString(), "picocli.AutoComplete", "--help"));
    return java(words.toArray(String[]::new));
  }

  private static String java(String... words) throws IOException, InterruptedException {
    List<String> command = new ArrayList<>(List.of(JAVA_HOME.resolve("bin/java").toString()));
    command.addAll(List.of(words));
    Process process = new ProcessBuilder(command).redirectErrorStream(true).start();
    String text = new String(process.getInputStream().readAllBytes(), StandardCharsets.UTF_8);
    assertEquals(0, process.waitFor(), text);
    return text;
  }
}
