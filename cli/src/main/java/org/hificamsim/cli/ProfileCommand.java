package org.hificamsim.cli;

import picocli.CommandLine;
import picocli.CommandLine.Command;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Spec;

/** {@code hificamsim profile}: from photos to a detection model. */
@Command(
    name = "profile",
    description = "Renders a laboratory, measures photos, and fits detection models to them.",
    subcommands = {LabCommand.class, MeasureCommand.class, FitCommand.class},
    mixinStandardHelpOptions = true)
final class ProfileCommand implements Runnable {
  @Spec private CommandSpec spec;

  @Override
  public void run() {
    throw new CommandLine.ParameterException(
        spec.commandLine(), "profile what? Expected lab, measure or fit");
  }
}
