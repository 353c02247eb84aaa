package org.hificamsim.cli;

import picocli.CommandLine.Command;

/** {@code hificamsim profile}: from photos to a detection model. */
@Command(
    name = "profile",
    description = "Renders a laboratory, measures photos, and fits detection models to them.",
    subcommands = {LabCommand.class, MeasureCommand.class, FitCommand.class})
final class ProfileCommand {}
