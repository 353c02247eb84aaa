package org.hificamsim.acceptance;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;

/** Runs the command line in a process of its own. */
final class Java {
  private Java() {}

  /** Starts a command; both its outputs are read from the process's input stream. */
  static Process main(String classPath, Object... words) throws IOException {
    return main(Path.of("."), List.of(), classPath, words);
  }

  /** The same in a folder, with options for the JVM. */
  static Process main(Path folder, List<String> options, String classPath, Object... words)
      throws IOException {
    List<String> command = new ArrayList<>();
    command.addAll(List.of("env", "--default-signal=INT")); // even where this process ignores it
    command.add(Path.of(System.getProperty("java.home"), "bin", "java").toString());
    command.addAll(List.of("-XX:+UseSerialGC", "-XX:TieredStopAtLevel=1")); // it is short
    command.addAll(options);
    command.add("-Dhificamsim.root=" + Cli.ROOT);
    command.add("-cp");
    command.add(classPath);
    command.add("org.hificamsim.cli.Main");
    for (Object word : words) {
      command.add(word.toString());
    }
    return new ProcessBuilder(command).directory(folder.toFile()).redirectErrorStream(true).start();
  }
}
