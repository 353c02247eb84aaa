package org.hificamsim.runs.compare;

import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.RunPlan;

/**
 * Computes one part of a comparison into a folder of its own, for {@link MergedShards}; safe to
 * kill at any moment.
 */
public final class ShardRun {
  private final Shard shard;
  private final List<RunPlan> plans;
  private final List<String> keys;
  private final List<RunTask> tasks;

  /**
   * @param plans of the whole comparison, made by {@link Yardsticks#with}
   */
  public ShardRun(Shard shard, List<RunPlan> plans) {
    this.shard = shard;
    this.plans = plans;
    this.keys = RunKey.of(plans).stream().map(RunKey::text).toList();
    this.tasks = shard.tasks(plans);
  }

  /** Writes a further file, such as a manifest. */
  @FunctionalInterface
  public interface Extra {
    /** Writes it. */
    void write(OutputFolder folder) throws IOException;
  }

  /** How many runs this part has. */
  public int runs() {
    return tasks.size();
  }

  /** How many steps those have together. */
  public long steps() {
    return tasks.stream().mapToLong(task -> plans.get(task.plan()).steps()).sum();
  }

  /**
   * Computes the part.
   *
   * @param engine where the runs are computed, configured
   * @param resume whether runs that are in the folder already count
   * @param progress hears of each run
   * @throws InputException when the folder holds another part
   */
  public void execute(RunEngine engine, boolean resume, RunProgress progress, Path out, Extra extra)
      throws IOException {
    try (OutputFolder folder = new OutputFolder(out)) {
      checkFolder(out, resume);
      try (Journal journal = Journal.open(folder, ShardFolder.RUNS, resume)) {
        ShardFolder.write(folder, shard, plans);
        engine.run(
            plans,
            missing(journal, progress),
            (task, outcome) -> {
              journal.add(keys.get(task.plan()), seed(task), outcome);
              progress.advance();
            });
        extra.write(folder);
        folder.commit(List.of());
      }
    }
  }

  private List<RunTask> missing(Journal journal, RunProgress progress) throws IOException {
    List<RunTask> missing = new ArrayList<>();
    for (RunTask task : tasks) {
      if (journal.find(keys.get(task.plan()), seed(task)).isEmpty()) {
        missing.add(task);
      }
    }
    progress.resume(tasks.size() - missing.size());
    return missing;
  }

  private long seed(RunTask task) {
    return plans.get(task.plan()).seed(task.repeat());
  }

  private void checkFolder(Path out, boolean resume) throws IOException {
    Optional<ShardFolder> found = ShardFolder.read(out);
    if (found.isEmpty() || found.get().isOf(shard, plans)) {
      return;
    }
    ShardFolder other = found.get();
    if (other.isOf(plans) || resume) {
      String comparison = other.isOf(plans) ? "" : " of another comparison" + other.changed(plans);
      throw new InputException(
          "--out '%s' holds shard %s%s, expected a folder of its own for %s"
              .formatted(out, other.shard(), comparison, shard));
    }
  }
}
