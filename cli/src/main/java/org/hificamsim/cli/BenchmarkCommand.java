package org.hificamsim.cli;

import picocli.CommandLine.Command;

/** {@code hificamsim benchmark}: frozen tasks that others can enter. */
@Command(
    name = "benchmark",
    description = "Plays frozen tasks that anybody can enter, and checks and ranks the results.",
    subcommands = {
      EntryCommand.class,
      EntryCheckCommand.class,
      LeaderboardCommand.class,
      ReplayCommand.class,
      ArenaCommand.class
    })
final class BenchmarkCommand {}
