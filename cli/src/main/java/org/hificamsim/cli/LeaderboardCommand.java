package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.benchmark.Benchmark;
import org.hificamsim.runs.benchmark.EntryCheck;
import org.hificamsim.runs.benchmark.Leaderboard;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code hificamsim benchmark leaderboard}: a page of checked entries. */
@Command(name = "leaderboard", description = "Checks entries, and writes a page of them.")
final class LeaderboardCommand implements Callable<Integer> {
  @Parameters(arity = "1..*", paramLabel = "DIR", description = "Folders of 'benchmark run'.")
  private List<Path> folders;

  @Option(names = "--out", required = true, paramLabel = "DIR")
  private Path out;

  @Mixin private ThreadsOption threads;

  @Mixin private Screen screen;

  @Override
  public Integer call() throws IOException {
    Benchmark benchmark = ShippedScenarios.tasks();
    EntryCheck check = new EntryCheck(benchmark, threads.count());
    Leaderboard board = new Leaderboard(benchmark, folders.stream().map(check::check).toList());
    try (OutputFolder folder = screen.folder(out)) {
      board.write(folder);
      folder.commit(List.of());
    }
    board.lines().forEach(screen.out()::println);
    screen.out().println("files: " + out);
    return 0;
  }
}
