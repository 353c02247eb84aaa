package org.hificamsim.cli;

import picocli.CommandLine.Command;

/** {@code hificamsim profile}: from photos to a detection model, and how true its optics are. */
@Command(
    name = "profile",
    description = {
      "Makes detection models from photos: renders or measures photos, fits models, checks them.",
      "Without photos of your own, begin with lab."
    },
    subcommands = {LabCommand.class, MeasureCommand.class, FitCommand.class, CheckCommand.class})
final class ProfileCommand {}
