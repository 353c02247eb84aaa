package org.hificamsim.runs.benchmark;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.file.Sha256;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.runs.benchmark.BenchmarkEntry.TaskScores;
import org.hificamsim.runs.output.ManifestFile;

/** Checks entries: plays their actions again, and compares what that scores. */
public final class EntryCheck {
  /** What a sum of rounded numbers may be above the best. */
  private static final double ROUNDING = 1e-9;

  private final Benchmark benchmark;
  private final int threads;

  /**
   * @param threads that share the episodes, 1 or more
   */
  public EntryCheck(Benchmark benchmark, int threads) {
    this.benchmark = benchmark;
    this.threads = threads;
  }

  /** An episode that is to be played again. */
  private record Again(String task, TaskScores of, int number, int[][] views, Path file) {}

  /**
   * Checks an entry.
   *
   * @param path its folder, or its file in it
   * @return the entry
   * @throws InputException when something does not agree, with the reason
   */
  public BenchmarkEntry check(Path path) {
    Path file = BenchmarkEntry.file(path);
    BenchmarkEntry entry = BenchmarkEntry.read(file);
    require(file, "version", entry.version(), ManifestFile.version());
    if (entry.tasks().isEmpty()) {
      throw InputException.of("%s: no task, expected one or more", file);
    }
    List<Again> episodes = new ArrayList<>();
    entry.tasks().forEach((task, scores) -> episodes.addAll(episodes(file, task, scores)));
    Parallel.map(episodes, threads, this::checked);
    return entry;
  }

  private List<Again> episodes(Path file, String name, TaskScores scores) {
    String what = file + ": " + name;
    BenchmarkTask task = benchmark.task(name);
    require(what, "task has hash", scores.task(), task.hash());
    require(what, "seeds", scores.seeds(), BenchmarkTask.TESTING);
    require(what, "number of scores", scores.scores().size(), scores.seeds().size());
    Path actions = file.resolveSibling(RecordedActions.file(name));
    List<int[][]> views = RecordedActions.read(actions, name, benchmark);
    require(actions, "SHA-256", Io.get(() -> Sha256.of(actions)), scores.actions());
    return IntStream.range(0, views.size())
        .mapToObj(i -> new Again(name, scores, i, views.get(i), actions))
        .toList();
  }

  private Again checked(Again one) {
    long seed = BenchmarkTask.TESTING.get(one.number);
    String what = one.file + ", seed " + seed;
    Episode episode =
        Episode.replay(benchmark, benchmark.plan(one.task, "zoom-out", seed), one.views, what);
    BenchmarkTask task = benchmark.task(one.task);
    require(what, "score", one.of.scores().get(one.number), episode.score());
    if (task.normalized(one.number, episode.score()) > 1 + ROUNDING) {
      throw InputException.of(
          "%s: score %s, expected at most %s, the best that is possible",
          what, episode.score(), task.best().get(one.number));
    }
    return one;
  }

  private static void require(Object where, String what, Object found, Object expected) {
    if (!found.equals(expected)) {
      throw InputException.of("%s: %s %s, expected %s", where, what, found, expected);
    }
  }
}
