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

/** What a command that takes its time says, and {@code --quiet}: the files, and not a word. */
final class Screen {
  @Spec(Spec.Target.MIXEE)
  private CommandSpec command;

  @Option(names = "--quiet")
  private boolean quiet;

  /** For results. */
  PrintWriter out() {
    return quiet ? nowhere() : command.commandLine().getOut();
  }

  /** Prints a line of results, whose form is as {@link String#format} takes it. */
  void say(String form, Object... values) {
    out().println(Texts.format(form, values));
  }

  /** Prints a line of warnings or progress. */
  void note(String form, Object... values) {
    err().println(Texts.format(form, values));
  }

  /** For warnings and progress. */
  PrintWriter err() {
    return quiet ? nowhere() : errors();
  }

  /** For errors, which are never left out. */
  PrintWriter errors() {
    return command.commandLine().getErr();
  }

  /**
   * The progress of the command, shown unless it is to be quiet.
   *
   * @param subject what is worked on; empty where the command's name says it
   * @param unit what is counted, as in {@code " steps"}
   */
  Progress progress(String subject, String unit, long total) {
    return new Progress(
        (command.name() + " " + subject).strip(),
        unit,
        total,
        err(),
        quiet ? Progress.NEVER : Progress.QUIET);
  }

  /** A folder to write into; what the command reads is kept as it is. */
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
