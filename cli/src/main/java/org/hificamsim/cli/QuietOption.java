package org.hificamsim.cli;

import java.io.PrintWriter;
import java.io.Writer;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;

/** {@code --quiet} of commands that take their time: the files, and not a word. */
final class QuietOption {
  @Option(
      names = "--quiet",
      description = "Print nothing but errors: no table, no warnings, no progress.")
  private boolean quiet;

  /** Where the command tells its results. */
  PrintWriter out(CommandSpec command) {
    return quiet ? nowhere() : command.commandLine().getOut();
  }

  /** Where the command tells warnings and progress. */
  PrintWriter err(CommandSpec command) {
    return quiet ? nowhere() : command.commandLine().getErr();
  }

  /**
   * The progress of the command, told unless it is to be quiet.
   *
   * @param unit what is counted, as in {@code " steps"}
   */
  Progress progress(CommandSpec command, String task, String unit, long total) {
    return new Progress(
        task,
        unit,
        total,
        err(command),
        quiet ? Progress.Telling.NOTHING : Progress.Telling.asLaunched());
  }

  private static PrintWriter nowhere() {
    return new PrintWriter(Writer.nullWriter());
  }
}
