package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.EngineSettings;
import org.hificamsim.runs.compare.LocalEngine;
import org.hificamsim.runs.compare.MergedShards;
import org.hificamsim.runs.compare.RunEngine;
import org.hificamsim.runs.compare.Shard;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/** The options of commands that run many plans. */
final class BatchOptions {
  @Mixin private ThreadsOption threads;

  @Option(names = "--out", paramLabel = "DIR")
  private Path out;

  @Option(names = "--resume")
  private boolean resume;

  @Option(names = "--engine", paramLabel = "local|spark")
  private String engine;

  @Option(names = "--master", paramLabel = "URL")
  private Optional<String> master;

  @Option(names = "--shard", paramLabel = "i/n")
  private Optional<String> shard;

  @Option(names = "--merge", arity = "1..*", paramLabel = "DIR")
  private List<Path> merge;

  Path out() {
    return out;
  }

  boolean resume() {
    return resume;
  }

  /** Whether all runs are still to be computed, by this machine. */
  boolean computesHere() {
    return merge == null && !resume && engine.equals(LocalEngine.NAME);
  }

  /** The part of the comparison that was asked for, if not the whole. */
  Optional<Shard> shard() {
    if (shard.isPresent() && merge != null) {
      throw new InputException("--shard and --merge are given, expected one of them");
    }
    return shard.map(Shard::parse);
  }

  /** Whether a part of the runs was asked for, or parts are put together. */
  boolean isInParts() {
    return shard.isPresent() || merge != null;
  }

  /** The threads that were asked for, 1 or more. */
  int threads() {
    return threads.count();
  }

  /**
   * Where the runs come from: the engine that was asked for, or the shards to merge.
   *
   * @param plans of the whole comparison, made by {@code ReferencePolicies.with}
   * @throws InputException when there is no such engine, it cannot work, or shards are missing
   */
  RunEngine engine(Catalogue catalogue, List<RunPlan> plans) throws IOException {
    RunEngine made = RunEngine.registry().create(engine);
    EngineSettings settings = new EngineSettings(catalogue, threads(), master);
    if (merge != null) {
      return new MergedShards(merge, plans);
    }
    made.configure(settings);
    return made;
  }
}
