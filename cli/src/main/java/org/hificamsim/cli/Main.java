package org.hificamsim.cli;

import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.util.ServiceConfigurationError;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.Unfinished;
import org.hificamsim.runs.output.ManifestFile;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.Spec;

/**
 * The command {@code hificamsim}.
 *
 * <p>Exit codes: 0 done; 2 wrong usage or bad input, told in one line; 1 anything else.
 */
@Command(
    name = "hificamsim",
    description = "Simulates smart-camera networks with detection models fitted to real images.",
    subcommands = {
      RunCommand.class,
      CompareCommand.class,
      ReproduceCommand.class,
      SensitivityCommand.class,
      PlotCommand.class,
      GenerateCommand.class,
      ReportCommand.class,
      ViewCommand.class,
      ValidateCommand.class,
      ListCommand.class,
      CamSimCommand.class,
      ProfileCommand.class
    },
    mixinStandardHelpOptions = true,
    versionProvider = Main.Version.class)
public final class Main implements Runnable {
  private static final int FAILURE = 1;
  private static final int BAD_INPUT = 2;

  @Spec private CommandSpec spec;

  /** Runs one command and exits with its code. */
  public static void main(String[] args) {
    PrintWriter out = new PrintWriter(System.out, true, StandardCharsets.UTF_8);
    PrintWriter err = new PrintWriter(System.err, true, StandardCharsets.UTF_8);
    Unfinished.deleteAtExit();
    System.exit(execute(out, err, args));
  }

  /** Runs one command. */
  public static int execute(PrintWriter out, PrintWriter err, String... args) {
    CommandLine line =
        new CommandLine(new Main())
            .setOut(out)
            .setErr(err)
            .setCaseInsensitiveEnumValuesAllowed(true)
            .setParameterExceptionHandler((fault, words) -> usage(fault))
            .setExecutionExceptionHandler((fault, command, parsed) -> failure(fault, command));
    try {
      return line.execute(args);
    } catch (OutOfMemoryError | StackOverflowError | LinkageError | ServiceConfigurationError e) {
      return failure(e, line);
    }
  }

  @Override
  public void run() {
    throw new ParameterException(
        spec.commandLine(),
        "no command, expected run, compare, reproduce, sensitivity, plot, generate, report, view,"
            + " validate, list, camsim or profile");
  }

  private static int usage(ParameterException fault) {
    CommandLine command = fault.getCommandLine();
    String name = command.getCommandSpec().qualifiedName();
    print(command, oneLine(fault.getMessage()) + "; see " + name + " --help");
    return BAD_INPUT;
  }

  private static int failure(Throwable fault, CommandLine command) {
    if (Boolean.getBoolean("hificamsim.debug")) {
      fault.printStackTrace(command.getErr());
    }
    if (fault instanceof InputException) {
      print(command, fault.getMessage());
      return BAD_INPUT;
    }
    if (fault instanceof UncheckedIOException io) {
      return failure(io.getCause(), command);
    }
    print(command, oneLine(fault.getClass().getSimpleName() + ": " + fault.getMessage()));
    return FAILURE;
  }

  private static void print(CommandLine command, String message) {
    command.getErr().println("error: " + Place.printable(message));
    command.getErr().flush();
  }

  private static String oneLine(String message) {
    return message.replaceAll("\\s+", " ").strip();
  }

  /** The version of this build. */
  static final class Version implements IVersionProvider {
    @Override
    public String[] getVersion() {
      return new String[] {"hificamsim " + ManifestFile.version()};
    }
  }
}
