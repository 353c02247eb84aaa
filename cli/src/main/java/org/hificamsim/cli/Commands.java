package org.hificamsim.cli;

import java.util.List;
import java.util.Locale;
import picocli.AutoComplete.GenerateCompletion;
import picocli.CommandLine;
import picocli.CommandLine.HelpCommand;

/**
 * The commands of {@code hificamsim}. A call that begins with the name of a command loads only this
 * command, because reading the options of all others takes a quarter of the time of a short
 * command.
 */
final class Commands {
  private static final List<Class<?>> ALL =
      List.of(
          RunCommand.class,
          CompareCommand.class,
          ReproduceCommand.class,
          SensitivityCommand.class,
          LadderCommand.class,
          TradeoffCommand.class,
          GenerateCommand.class,
          ImportCommand.class,
          SiteCommand.class,
          PlaceCommand.class,
          BenchmarkCommand.class,
          ReportCommand.class,
          ViewCommand.class,
          ValidateCommand.class,
          ListCommand.class,
          CamSimCommand.class,
          ProfileCommand.class,
          HelpCommand.class,
          GenerateCompletion.class);

  /** Commands about the other commands, which need all of them. */
  private static final List<Class<?>> NEED_ALL =
      List.of(HelpCommand.class, GenerateCompletion.class);

  private Commands() {}

  /** The command line for a call. */
  static CommandLine line(String... args) {
    return args.length == 0 ? all() : lineOf(neededFor(args[0]));
  }

  /** The command line with all commands. */
  static CommandLine all() {
    return lineOf(ALL);
  }

  private static List<Class<?>> neededFor(String name) {
    return ALL.stream()
        .filter(command -> !NEED_ALL.contains(command))
        .filter(command -> nameOf(command).equals(name))
        .findAny()
        .<List<Class<?>>>map(List::of)
        .orElse(ALL);
  }

  /** The name of a command, from its class's name: annotations take a tenth of a start to read. */
  static String nameOf(Class<?> command) {
    return command.getSimpleName().replaceFirst("Command$", "").toLowerCase(Locale.ROOT);
  }

  private static CommandLine lineOf(List<Class<?>> commands) {
    CommandLine line = new CommandLine(new Main());
    commands.forEach(line::addSubcommand);
    return line;
  }
}
