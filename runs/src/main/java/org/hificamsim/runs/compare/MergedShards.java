package org.hificamsim.runs.compare;

import static org.hificamsim.core.NamedSetting.setting;

import java.io.IOException;
import java.nio.file.Path;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.runs.RunPlan;

/** An engine that reads the runs of a comparison from the folders of its shards. */
public final class MergedShards implements RunEngine {
  private final List<Path> folders;

  /**
   * Checks that the folders have all runs.
   *
   * @param folders the folders of shards
   * @param plans the plans of the whole comparison, made by {@link ReferencePolicies#with}
   * @throws InputException when a run is missing, damaged, or of another input of the same name
   */
  public MergedShards(List<Path> folders, List<RunPlan> plans) throws IOException {
    this.folders = folders;
    List<RunKey> keys = RunKey.of(plans);
    List<String> texts = keys.stream().map(RunKey::text).toList();
    List<RunTask> all = new Shard(1, 1).tasks(plans);
    Set<RunTask> missing = new LinkedHashSet<>(all);
    for (Path folder : folders) {
      try (Journal runs = Journal.ofShard(folder)) {
        requireUndamaged(runs);
        runs.requireUnchanged(keys);
        missing.removeIf(task -> runs.has(texts.get(task.plan()), seed(plans, task)));
      }
    }
    if (!missing.isEmpty()) {
      RunTask first = missing.iterator().next();
      RunPlan plan = plans.get(first.plan());
      throw InputException.of(
          "%s lacks %s of %s runs, such as scenario %s, detection %s, policy %s, seed %s:"
              + " expected all, with the options that the shards had; %s with %s computes what a"
              + " shard lacks",
          setting("merge"),
          missing.size(),
          all.size(),
          plan.scenario().name(),
          plan.detection().name(),
          plan.policy(),
          seed(plans, first),
          setting("shard", "i/n"),
          setting("resume"));
    }
  }

  @Override
  public String name() {
    return "merge";
  }

  @Override
  public void run(List<RunPlan> plans, List<RunTask> tasks, Finished finished) throws IOException {
    List<String> keys = RunKey.of(plans).stream().map(RunKey::text).toList();
    Set<RunTask> remaining = new LinkedHashSet<>(tasks);
    for (Path folder : folders) {
      try (Journal runs = Journal.ofShard(folder)) {
        for (RunTask task : List.copyOf(remaining)) {
          Optional<FinishedRun> found = runs.find(keys.get(task.plan()), seed(plans, task));
          if (found.isPresent()) {
            finished.take(task, found.get());
            remaining.remove(task);
          }
        }
      }
    }
  }

  private static long seed(List<RunPlan> plans, RunTask task) {
    return plans.get(task.plan()).seed(task.repeat());
  }

  private static void requireUndamaged(Journal runs) {
    runs.damage()
        .ifPresent(
            damage -> {
              throw InputException.of(
                  "%s, expected what %s wrote; with %s it computes it again",
                  damage, setting("shard"), setting("resume"));
            });
  }
}
