package org.hificamsim.cli;

import picocli.CommandLine.Command;

/** {@code hificamsim benchmark}: what others have measured, measured again. */
@Command(
    name = "benchmark",
    description = "Scores recorded episodes of another simulator.",
    subcommands = ReplayCommand.class)
final class BenchmarkCommand {}
