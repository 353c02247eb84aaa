package org.hificamsim.runs.compare;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Map;
import java.util.Set;
import java.util.TreeMap;
import java.util.stream.Collectors;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.runs.RunPlan;

/**
 * The runs of a comparison from the folders of all its shards, as an engine that computes nothing.
 */
public final class MergedShards implements RunEngine {
  private static final int MAX_NAMED = 10;

  private final Map<Integer, ShardFolder> shards = new TreeMap<>();

  /**
   * Checks that the shards are there, each once and complete.
   *
   * @param folders of {@code --shard} runs
   * @param plans of the whole comparison, made by {@link ReferencePolicies#with}
   * @throws InputException naming what is missing, comes twice or belongs to another comparison
   */
  public MergedShards(List<Path> folders, List<RunPlan> plans) throws IOException {
    for (Path folder : folders) {
      add(shardOf(folder, plans));
    }
    requireAll();
    for (ShardFolder shard : shards.values()) {
      requireComplete(shard, plans);
    }
  }

  @Override
  public String name() {
    return "merge";
  }

  @Override
  public void run(List<RunPlan> plans, List<RunTask> tasks, Finished finished) throws IOException {
    List<String> keys = RunKey.of(plans).stream().map(RunKey::text).toList();
    Set<RunTask> wanted = Set.copyOf(tasks);
    for (ShardFolder shard : shards.values()) {
      try (Journal runs = shard.runs()) {
        for (RunTask task : shard.shard().tasks(plans)) {
          if (wanted.contains(task)) {
            long seed = plans.get(task.plan()).seed(task.repeat());
            finished.take(task, runs.find(keys.get(task.plan()), seed).orElseThrow());
          }
        }
      }
    }
  }

  private static ShardFolder shardOf(Path folder, List<RunPlan> plans) throws IOException {
    ShardFolder shard =
        ShardFolder.read(folder)
            .orElseThrow(
                () ->
                    InputException.of(
                        "--merge '%s' has no shard.json, expected a folder that --shard wrote",
                        folder));
    if (!shard.isOf(plans)) {
      throw InputException.of(
          "--merge '%s' is shard %s of another comparison%s, expected this one's"
              + " scenarios, models, policies, yardsticks, steps, seeds and version",
          folder, shard.shard(), shard.changed(plans));
    }
    return shard;
  }

  private void add(ShardFolder shard) {
    for (ShardFolder other : shards.values()) {
      if (other.shard().of() != shard.shard().of()) {
        throw InputException.of(
            "--merge '%s' is shard %s but '%s' is shard %s, expected parts of one split",
            shard.path(), shard.shard(), other.path(), other.shard());
      }
    }
    ShardFolder other = shards.putIfAbsent(shard.shard().number(), shard);
    if (other != null) {
      throw InputException.of(
          "--merge has shard %s twice, '%s' and '%s', expected each once",
          shard.shard(), other.path(), shard.path());
    }
  }

  private void requireAll() {
    int of = shards.values().iterator().next().shard().of();
    int missing = of - shards.size();
    if (missing > 0) {
      throw InputException.of(
          "--merge lacks %s of %s shards (%s%s), expected all",
          missing,
          of,
          IntStream.rangeClosed(1, of)
              .filter(i -> !shards.containsKey(i))
              .limit(MAX_NAMED)
              .mapToObj(String::valueOf)
              .collect(Collectors.joining(", ")),
          missing > MAX_NAMED ? ", ..." : "");
    }
  }

  private static void requireUndamaged(Journal runs, ShardFolder shard) {
    runs.damage()
        .ifPresent(
            damage -> {
              throw InputException.of(
                  "%s, expected what --shard wrote; --shard %s --resume computes it again",
                  damage, shard.shard());
            });
  }

  private static void requireComplete(ShardFolder shard, List<RunPlan> plans) throws IOException {
    List<RunTask> tasks = shard.shard().tasks(plans);
    List<String> keys = RunKey.of(plans).stream().map(RunKey::text).toList();
    long there = 0;
    try (Journal runs = shard.runs()) {
      requireUndamaged(runs, shard);
      for (RunTask task : tasks) {
        boolean has = runs.has(keys.get(task.plan()), plans.get(task.plan()).seed(task.repeat()));
        there += has ? 1 : 0;
      }
    }
    if (there < tasks.size()) {
      throw InputException.of(
          "--merge '%s' has %s of the %s runs of shard %s, expected all; --shard %s"
              + " --resume computes the rest",
          shard.path(), there, tasks.size(), shard.shard(), shard.shard());
    }
  }
}
