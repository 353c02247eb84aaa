package org.hificamsim.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.concurrent.Callable;
import org.hificamsim.runs.benchmark.BenchmarkEntry;
import org.hificamsim.runs.benchmark.EntryCheck;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Parameters;

/** {@code hificamsim benchmark check}: whether entries scored what they say. */
@Command(
    name = "check",
    description = "Plays the recorded actions of entries again; refuses what scores otherwise.")
final class EntryCheckCommand implements Callable<Integer> {
  @Parameters(arity = "1..*", paramLabel = "DIR", description = "Folders of 'benchmark run'.")
  private List<Path> folders;

  @Mixin private ThreadsOption threads;

  @Mixin private Screen screen;

  @Override
  public Integer call() {
    EntryCheck check = new EntryCheck(ShippedScenarios.tasks(), threads.count());
    for (Path folder : folders) {
      BenchmarkEntry entry = check.check(folder);
      screen.say("%s: %s, %d tasks, agrees", folder, entry.name(), entry.tasks().size());
    }
    return 0;
  }
}
