package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.EngineSettings;
import org.hificamsim.runs.compare.Engines;
import org.hificamsim.runs.compare.LocalEngine;
import org.hificamsim.runs.compare.MergedShards;
import org.hificamsim.runs.compare.RunEngine;
import org.hificamsim.runs.compare.Shard;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options of commands that run many plans. */
final class BatchOptions {
  private static final int MOST_STEPS = 10_000_000;
  private static final int MOST_REPEATS = 100_000;

  @Option(names = "--seed", paramLabel = "N", defaultValue = "0", description = "First seed.")
  private long seed;

  @Mixin private QuietOption quiet;

  @Option(names = "--resume", description = "Keep the runs that a killed command finished.")
  private boolean resume;

  @Option(
      names = "--threads",
      paramLabel = "N",
      defaultValue = "0",
      description = "Threads; 0 for one per processor. Results do not depend on it.")
  private int threads;

  @Option(
      names = "--engine",
      paramLabel = "local|spark",
      defaultValue = LocalEngine.NAME,
      description = "Where to compute. Results do not depend on it.")
  private String engine;

  @Option(
      names = "--master",
      paramLabel = "URL",
      description = "The cluster's master for --engine spark: spark://HOST:PORT, local[*], yarn.")
  private String master;

  @Option(
      names = "--shard",
      paramLabel = "i/n",
      description = "Only the i-th of n parts, into a folder of its own, for --merge.")
  private String shard;

  @Option(
      names = "--merge",
      arity = "1..*",
      paramLabel = "DIR",
      description = "Take all runs from these folders of --shard; all other options as there.")
  private List<Path> merge;

  /** Checks the numbers, those of the command with them. */
  void check(int steps, int repeats) {
    Numbers.inRange("--steps", steps, 1, MOST_STEPS);
    Numbers.inRange("--repeat", repeats, 1, MOST_REPEATS);
    Numbers.seeds(seed, repeats);
    Threads.check(threads);
  }

  long seed() {
    return seed;
  }

  boolean resume() {
    return resume;
  }

  QuietOption quiet() {
    return quiet;
  }

  /** The part of the sweep that was asked for, if not the whole. */
  Optional<Shard> shard() {
    Optional<Shard> asked = Optional.ofNullable(shard).map(Shard::parse);
    if (asked.isPresent() && merge != null) {
      throw new InputException("--shard and --merge are given, expected one of them");
    }
    return asked;
  }

  /**
   * Where the runs come from: the engine that was asked for, or the shards to merge.
   *
   * @param plans of the whole sweep, made by {@code Comparison.withOptimum}
   * @throws InputException when there is no such engine, it cannot work, or shards are missing
   */
  RunEngine engine(Catalogue catalogue, List<RunPlan> plans) throws IOException {
    RunEngine made = Engines.registry().create(engine);
    if (merge != null) {
      return new MergedShards(merge, plans);
    }
    made.configure(new EngineSettings(catalogue, threads(), Optional.ofNullable(master)));
    return made;
  }

  private int threads() {
    return Threads.number(threads);
  }
}
