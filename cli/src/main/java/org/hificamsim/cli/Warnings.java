package org.hificamsim.cli;

import java.io.PrintWriter;
import java.util.function.Consumer;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import picocli.CommandLine.Option;

/** {@code --strict}, and what becomes of warnings about scenario files. */
final class Warnings {
  @Option(names = "--strict", description = "Take warnings about the input as errors.")
  private boolean strict;

  /** Whether they are errors. */
  boolean strict() {
    return strict;
  }

  /** Takes warnings: each is a line on {@code err}, or the error that ends the command. */
  Consumer<String> on(PrintWriter err) {
    return warning -> {
      if (strict) {
        throw new InputException(asError(warning));
      }
      err.println("warning: " + Place.printable(warning));
    };
  }

  /** What a warning says where it is an error. */
  static String asError(String warning) {
    return warning + "; expected no warning, with --strict";
  }
}
