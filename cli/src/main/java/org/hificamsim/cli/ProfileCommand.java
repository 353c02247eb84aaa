package org.hificamsim.cli;

import picocli.CommandLine.Command;

/** {@code hificamsim profile}: makes detection models from photos, and checks their optics. */
@Command(
    name = "profile",
    description = {
      "Makes detection models from photos or labelled recordings, and checks them.",
      "Without photos of your own, begin with lab."
    },
    subcommands = {
      LabCommand.class,
      MeasureCommand.class,
      FitCommand.class,
      BoxesCommand.class,
      CheckCommand.class
    })
final class ProfileCommand {}
