package org.hificamsim.acceptance;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.cli.Main;

/** Runs the command line, or another class, in a process of its own. */
final class Java {
  /** Options for a JVM that ends soon. */
  static final List<String> SHORT_LIVED = List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1");

  private Java() {}

  /** Starts a command; both its outputs are read from the process's input stream. */
  static Process main(String classPath, Object... words) throws IOException {
    return main(Path.of("."), List.of(), classPath, words);
  }

  /** Starts a command in a folder, with options for the JVM. */
  static Process main(Path folder, List<String> options, String classPath, Object... words)
      throws IOException {
    return start(folder, options, classPath, Main.class.getName(), words);
  }

  /** Starts another class in a folder, with options for the JVM. */
  static Process start(
      Path folder, List<String> options, String classPath, String main, Object... words)
      throws IOException {
    List<String> command = new ArrayList<>();
    command.addAll(List.of("env", "--default-signal=INT")); // even where this process ignores it
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(SHORT_LIVED);
    command.addAll(options);
    command.add("-Dhificamsim.root=" + Cli.ROOT);
    command.add("-cp");
    command.add(classPath);
    command.add(main);
    for (Object word : words) {
      command.add(word.toString());
    }
    return new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).start();
  }
}
