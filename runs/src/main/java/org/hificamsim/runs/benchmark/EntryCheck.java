package org.hificamsim.runs.benchmark;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.Io;
import org.hificamsim.core.file.Sha256;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.benchmark.BenchmarkEntry.TaskScores;
import org.hificamsim.runs.output.ManifestFile;

/** Checks entries: plays their actions again and compares the scores. */
public final class EntryCheck {
  /** The most by which a sum of rounded numbers may exceed the best score. */
  private static final double ROUNDING = 1e-9;

  private final Benchmark benchmark;
  private final int threads;

  /**
   * @param threads the number of threads that share the episodes, 1 or more
   */
  public EntryCheck(Benchmark benchmark, int threads) {
    this.benchmark = benchmark;
    this.threads = threads;
  }

  /**
   * An episode of an entry that is to be played again.
   *
   * @param scores the scores of all episodes of the task
   * @param number the number of the episode, from 0
   * @param views the view that each camera had chosen, by step
   * @param file the file of the actions
   */
  private record RecordedEpisode(
      String task, TaskScores scores, int number, int[][] views, Path file) {}

  /**
   * Checks an entry.
   *
   * @param path the path of its folder or file
   * @return the entry
   * @throws InputException when something differs, with the reason
   */
  public BenchmarkEntry check(Path path) {
    Path file = BenchmarkEntry.file(path);
    BenchmarkEntry entry = BenchmarkEntry.read(file);
    require(file, "version", entry.version(), ManifestFile.version());
    if (entry.tasks().isEmpty()) {
      throw InputException.of("%s: no task, expected one or more", file);
    }
    EnteredPolicy.requireUnchangedFiles(file, entry);
    List<RecordedEpisode> episodes = new ArrayList<>();
    entry.tasks().forEach((task, scores) -> episodes.addAll(episodes(file, task, scores)));
    Parallel.map(episodes, threads, this::check);
    return entry;
  }

  private List<RecordedEpisode> episodes(Path file, String name, TaskScores scores) {
    String where = file + ": " + name;
    if (!benchmark.names().contains(name)) {
      throw InputException.of(
          "%s: task '%s', expected one of %s", file, name, String.join(", ", benchmark.names()));
    }
    BenchmarkTask task = benchmark.task(name);
    benchmark.requireUnchanged(name);
    require(where, "task has hash", scores.task(), task.hash());
    require(where, "seeds", scores.seeds(), BenchmarkTask.TESTING);
    require(where, "number of scores", scores.scores().size(), scores.seeds().size());
    Path actions = file.resolveSibling(RecordedActions.file(name));
    BenchmarkEntry.requireRegular(actions);
    List<int[][]> views = RecordedActions.read(actions, name, benchmark);
    require(actions, "SHA-256", Io.get(() -> Sha256.of(actions)), scores.actions());
    return IntStream.range(0, views.size())
        .mapToObj(i -> new RecordedEpisode(name, scores, i, views.get(i), actions))
        .toList();
  }

  private RecordedEpisode check(RecordedEpisode recorded) {
    int number = recorded.number;
    long seed = BenchmarkTask.TESTING.get(number);
    String where = recorded.file + ", seed " + seed;
    RunPlan plan = benchmark.plan(recorded.task, "zoom-out", seed);
    double score = Episode.replay(benchmark, plan, recorded.views, where).score();
    BenchmarkTask task = benchmark.task(recorded.task);
    require(where, "score", recorded.scores.scores().get(number), score);
    if (task.normalized(number, score) > 1 + ROUNDING) {
      throw InputException.of(
          "%s: score %s, expected at most %s, the best that is possible",
          where, score, task.best().get(number));
    }
    return recorded;
  }

  private static void require(Object where, String property, Object found, Object expected) {
    if (!found.equals(expected)) {
      throw InputException.of("%s: %s %s, expected %s", where, property, found, expected);
    }
  }
}
