package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.benchmark.Benchmark;
import org.hificamsim.runs.benchmark.BenchmarkEntry;
import org.hificamsim.runs.benchmark.BenchmarkTask;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** {@code hificamsim benchmark run}: a policy plays the testing episodes of the tasks. */
@Command(
    name = "run",
    description = "Plays the testing episodes of the tasks, and writes scores and actions.")
final class EntryCommand implements Callable<Integer> {
  @Option(names = "--policy", required = true, paramLabel = "NAME[:key=value,...]")
  private String policy;

  @Option(names = "--name", paramLabel = "TEXT")
  private Optional<String> name;

  @Option(names = "--tasks", paramLabel = "A,B")
  private Optional<String> tasks;

  @Option(names = "--out", required = true, paramLabel = "DIR")
  private Path out;

  @Mixin private ThreadsOption threads;

  @Mixin private Screen screen;

  @Override
  public Integer call() throws IOException {
    Benchmark benchmark = ShippedScenarios.tasks();
    List<String> asked = tasks.map(text -> names(text, benchmark)).orElseGet(benchmark::names);
    int episodes = asked.size() * BenchmarkTask.TESTING.size();
    try (OutputFolder folder = screen.folder(out);
        Progress progress = screen.progress("", " episodes", episodes)) {
      BenchmarkEntry entry =
          BenchmarkEntry.play(
              benchmark, name.orElse(policy), policy, asked, threads.count(), progress, folder);
      folder.commit(List.of());
      for (String task : asked) {
        screen.say("%-14s %s", task, Estimate.mean(entry.normalized(benchmark, task)).text("%.3f"));
      }
    }
    screen.out().println("files: " + out);
    return 0;
  }

  private static List<String> names(String text, Benchmark benchmark) {
    List<String> names = Arrays.stream(text.split(",", -1)).map(Benchmark::plain).toList();
    names.forEach(benchmark::task);
    NameLists.requireDistinct("--tasks", names);
    return names;
  }
}
