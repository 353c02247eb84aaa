package org.hificamsim.cli;

import picocli.CommandLine.Command;

/** {@code hificamsim profile}: from photos to a detection model, and how true its optics are. */
@Command(
    name = "profile",
    description = {
      "Renders a laboratory, measures photos, and fits detection models to them; checks predicted",
      "sizes against a recording."
    },
    subcommands = {LabCommand.class, MeasureCommand.class, FitCommand.class, CheckCommand.class})
final class ProfileCommand {}
