package org.hificamsim.cli;

import java.io.FileDescriptor;
import java.io.FileOutputStream;
import java.io.IOException;
import java.io.InputStream;
import java.io.PrintWriter;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.InvalidPathException;
import java.nio.file.Path;
import java.util.List;
import java.util.Properties;
import java.util.PropertyResourceBundle;
import java.util.ResourceBundle;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Nearest;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.Unfinished;
import org.hificamsim.runs.RunFault;
import org.hificamsim.runs.output.ManifestFile;
import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.IVersionProvider;
import picocli.CommandLine.ParameterException;
import picocli.CommandLine.PropertiesDefaultProvider;
import picocli.CommandLine.ScopeType;
import picocli.CommandLine.TypeConversionException;
import picocli.CommandLine.UnmatchedArgumentException;

/**
 * The command {@code hificamsim}.
 *
 * <p>The exit code is 0 for success, 2 for wrong usage or bad input, which are reported in one
 * line, and 1 for any other failure.
 */
@Command(
    name = "hificamsim",
    description = "Simulates smart-camera networks with detection models fitted to real images.",
    scope = ScopeType.INHERIT,
    mixinStandardHelpOptions = true,
    showDefaultValues = true,
    versionProvider = Main.Version.class)
public final class Main {
  static final int BAD_INPUT = 2;
  private static final int FAILURE = 1;
  private static final String DEFAULT = ".default";

  /** The number of characters that are kept of the start and the end of a long message. */
  private static final int KEPT_CHARACTERS = 400;

  /** Runs one command and exits with its code. */
  public static void main(String[] args) {
    PrintWriter out = new PrintWriter(System.out, true, StandardCharsets.UTF_8);
    PrintWriter err = new PrintWriter(System.err, true, StandardCharsets.UTF_8);
    Unfinished.deleteAtExit();
    System.exit(execute(out, err, args));
  }

  /** Runs one command. */
  public static int execute(PrintWriter out, PrintWriter err, String... args) {
    ResourceBundle options = options();
    CommandLine line =
        Commands.line(args)
            .setOut(new PrintWriter(new EscapedWriter(out), true))
            .setErr(err)
            .setResourceBundle(options)
            .setDefaultValueProvider(new PropertiesDefaultProvider(defaults(options)))
            .setCaseInsensitiveEnumValuesAllowed(true)
            .registerConverter(Path.class, Main::path)
            .setParameterExceptionHandler((fault, words) -> usage(fault))
            .setExecutionExceptionHandler((fault, command, parsed) -> failure(fault, command));
    try {
      int exit = line.execute(args);
      return exit == 0 && out.checkError() ? reportFailedOutput(line) : exit;
    } catch (Error e) {
      return failure(e, line);
    }
  }

  /** Reports that the output failed, unless its reader stopped reading, as {@code head} does. */
  private static int reportFailedOutput(CommandLine line) {
    try {
      new FileOutputStream(FileDescriptor.out).write('\n');
    } catch (IOException e) {
      if (String.valueOf(e.getMessage())
          .contains("roken pipe")) { // other languages add the English text in brackets
        return 0;
      }
    }
    return end(
        line, "standard output cannot be written, expected a place with room for it", FAILURE);
  }

  /** The help texts of all options, and their defaults. */
  static ResourceBundle options() {
    try (InputStream in = Main.class.getResourceAsStream("options.properties")) {
      return new PropertyResourceBundle(in);
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  static Properties defaults(ResourceBundle options) {
    Properties defaults = new Properties();
    options.keySet().stream()
        .filter(key -> key.endsWith(DEFAULT))
        .forEach(key -> defaults.put(key.replace(DEFAULT, ""), options.getString(key)));
    return defaults;
  }

  private static int usage(ParameterException fault) {
    CommandLine command = fault.getCommandLine();
    String name = command.getCommandSpec().qualifiedName();
    return end(command, oneLine(message(fault)) + "; see " + name + " --help", BAD_INPUT);
  }

  private static Path path(String text) {
    try {
      return Path.of(text);
    } catch (InvalidPathException e) {
      throw new TypeConversionException(
          "'%s' is no file's name (%s)".formatted(text, e.getReason()));
    }
  }

  /** Adds the valid words to a message, or the word that the user probably meant. */
  private static String message(ParameterException fault) {
    Set<String> commands = fault.getCommandLine().getSubcommands().keySet();
    if (!(fault instanceof UnmatchedArgumentException unmatched)) {
      String expected = commands.isEmpty() ? "" : ", expected " + String.join(", ", commands);
      return fault.getMessage() + expected;
    }
    if (!commands.isEmpty() && !unmatched.isUnknownOption()) {
      String word = unmatched.getUnmatched().get(0);
      return "unknown command '%s', expected one of %s".formatted(word, Nearest.to(word, commands));
    }
    List<String> similar = unmatched.getSuggestions();
    return fault.getMessage()
        + (similar.isEmpty() ? "" : ", maybe " + String.join(" or ", similar));
  }

  private static int failure(Throwable fault, CommandLine command) {
    if (Boolean.getBoolean("hificamsim.debug")) {
      fault.printStackTrace(command.getErr());
    }
    if (fault instanceof InputException input) {
      return end(command, input.message(Flags.NOTATION), BAD_INPUT);
    }
    if (fault instanceof UncheckedIOException io) {
      return failure(io.getCause(), command);
    }
    if (fault instanceof OutOfMemoryError) {
      String hint =
          "out of memory, expected fewer steps or cameras, or HIFICAMSIM_OPTS=-Xmx8g or more";
      return end(command, hint, FAILURE);
    }
    return end(command, oneLine(message(fault)), FAILURE);
  }

  private static String message(Throwable fault) {
    if (fault instanceof RunFault) {
      return fault.getMessage();
    }
    return fault instanceof RuntimeException
        ? RunFault.describe(fault)
        : fault.getClass().getSimpleName() + ": " + fault.getMessage();
  }

  private static int end(CommandLine command, String message, int code) {
    command.getErr().println("error: " + Place.printable(shortened(message)));
    command.getErr().flush();
    return code;
  }

  /** Omits the middle of a long message and keeps its end, which says what was expected. */
  private static String shortened(String message) {
    int length = message.length();
    return length <= 2 * KEPT_CHARACTERS
        ? message
        : message.substring(0, KEPT_CHARACTERS)
            + "..."
            + message.substring(length - KEPT_CHARACTERS);
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
