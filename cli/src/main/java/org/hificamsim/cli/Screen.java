package org.hificamsim.cli;

import java.io.PrintWriter;
import java.io.Writer;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** The terminal output of a command; with {@code --quiet}, only errors. */
final class Screen {
  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  @Option(names = "--quiet")
  private boolean quiet;

  /** The writer for results. */
  PrintWriter out() {
    return quiet ? nowhere() : command.commandLine().getOut();
  }

  /** Prints a line of results, with a format as in {@link String#format}. */
  void say(String form, Object... values) {
    out().println(Texts.format(form, values));
  }

  /** Prints a line of warnings or progress. */
  void note(String form, Object... values) {
    err().println(Texts.format(form, values));
  }

  /** The writer for warnings and progress. */
  PrintWriter err() {
    return quiet ? nowhere() : errors();
  }

  /** The writer for errors, which are always printed. */
  PrintWriter errors() {
    return command.commandLine().getErr();
  }

  /**
   * The progress of the command, which is shown unless the command is quiet.
   *
   * @param subject the subject of the work; empty if the name of the command tells it
   * @param unit the unit that is counted, such as {@code " steps"}
   */
  Progress progress(String subject, String unit, long total) {
    return new Progress(
        (command.name() + " " + subject).strip(),
        unit,
        total,
        err(),
        quiet ? Progress.NEVER : Progress.INITIAL_DELAY);
  }

  /** A folder to write into, in which the inputs of the command are protected. */
  OutputFolder folder(Path path) {
    return Destination.folder(command, path);
  }

  /** The words of the command line. */
  List<String> words() {
    return command.root().commandLine().getParseResult().originalArgs();
  }

  private static PrintWriter nowhere() {
    return new PrintWriter(Writer.nullWriter());
  }
}
