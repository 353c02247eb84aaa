package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.function.Consumer;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.presentation.report.Report;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.ScoredRun;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Comparison;
import org.hificamsim.runs.compare.ComparisonFiles;
import org.hificamsim.runs.compare.EngineSettings;
import org.hificamsim.runs.compare.Journal;
import org.hificamsim.runs.compare.JournalledEngine;
import org.hificamsim.runs.compare.LocalEngine;
import org.hificamsim.runs.compare.MergedShards;
import org.hificamsim.runs.compare.ReferencePolicies;
import org.hificamsim.runs.compare.RunEngine;
import org.hificamsim.runs.compare.RunTask;
import org.hificamsim.runs.compare.Shard;
import org.hificamsim.runs.output.CrateFile;
import org.hificamsim.runs.output.InputFiles;
import org.hificamsim.runs.output.ManifestFile;
import org.hificamsim.runs.output.ResultFolder;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;

/**
 * Executes the runs of a command that has many, with progress, a manifest, the page and a summary.
 * Has the options that all such commands share.
 */
final class BatchRun {
  /** Writes the files that only the present command has. */
  @FunctionalInterface
  interface Files {
    /** Adds the files to those of a folder, and returns a printer of their summary. */
    Consumer<PrintWriter> write(OutputFolder folder, List<CaseResult> results) throws IOException;
  }

  /** Computes the runs of a command, and writes the files that only this command has. */
  @FunctionalInterface
  interface Work {
    /**
     * Adds the files to those of a folder, and returns a printer of their summary.
     *
     * @param engine the engine, which keeps finished runs for {@code --resume}
     */
    Consumer<PrintWriter> write(OutputFolder folder, RunEngine engine) throws IOException;
  }

  /**
   * The runs of a command.
   *
   * @param plans the plans, of which a shard computes a part
   * @param inputs plans with each scenario and detection, for the files about the inputs
   * @param steps the most steps of all runs together
   * @param hasPage whether a page is made of the results
   */
  record Runs(List<RunPlan> plans, List<RunPlan> inputs, long steps, boolean hasPage) {
    /** The number of runs, which is greater than that of the plans if a search adds some. */
    long count() {
      int longest = plans.stream().mapToInt(RunPlan::steps).max().orElse(1);
      return Math.max(plans.stream().mapToLong(RunPlan::repeats).sum(), steps / longest);
    }
  }

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

  private final Instant started = Instant.now();
  private Screen screen;

  /** The number of threads, 1 or more. */
  int threads() {
    return threads.count();
  }

  /** Whether this machine computes all runs. */
  boolean computesHere() {
    return merge == null && !resume && engine.equals(LocalEngine.NAME);
  }

  /** Whether only a part of the runs is computed, or parts are merged. */
  boolean isInParts() {
    return shard.isPresent() || merge != null;
  }

  /**
   * Checks that every plan can start, then runs all of them, or the shard that was asked for.
   *
   * @param references the yardsticks that are run in addition to the plans
   * @param files writes the files that only this command has; not called for a shard
   * @return the exit code
   * @throws InputException when a plan cannot start; nothing is written then
   */
  int execute(
      Screen newScreen,
      Catalogue catalogue,
      ReferencePolicies references,
      List<RunPlan> plans,
      Files files)
      throws IOException {
    List<RunPlan> all = references.with(plans);
    long steps = all.stream().mapToLong(RunPlan::work).sum();
    Work work =
        (folder, journalled) -> {
          List<CaseResult> results = Comparison.run(plans, references, journalled);
          warnOfFewSeeds(plans.get(0).repeats());
          results.forEach(this::warnOfUnproven);
          return files.write(folder, results);
        };
    return execute(newScreen, catalogue, new Runs(all, all, steps, true), work);
  }

  /**
   * Checks that every plan can start, then does the work, or computes the shard that was asked for.
   *
   * @return the exit code
   * @throws InputException when a plan cannot start, the engine is unknown or cannot work, or
   *     shards are missing; nothing is written then
   */
  int execute(Screen newScreen, Catalogue catalogue, Runs runs, Work work) throws IOException {
    screen = newScreen;
    List<RunPlan> plans = runs.plans();
    plans.forEach(new RunExecutor(catalogue)::check);
    if (shard.isPresent() && merge != null) {
      throw new InputException("--shard and --merge are given, expected one of them");
    }
    Optional<Shard> part = shard.map(Shard::parse);
    RunEngine runEngine = RunEngine.registry().create(engine);
    if (merge == null) {
      runEngine.configure(new EngineSettings(catalogue, threads(), master));
    } else {
      runEngine = new MergedShards(merge, plans);
    }
    if (part.isPresent()) {
      compute(part.get(), runEngine, plans);
    } else {
      computeAll(runEngine, runs, work).accept(screen.out());
    }
    screen.out().println("files: " + out);
    return 0;
  }

  private Consumer<PrintWriter> computeAll(RunEngine runEngine, Runs runs, Work work)
      throws IOException {
    try (OutputFolder folder = screen.folder(out);
        Journal journal = Journal.open(folder, Journal.COMPARISON_FILE, resume)) {
      folder.claim(
          List.of(
              ResultFolder.SETTINGS,
              ResultFolder.MANIFEST,
              ResultFolder.CRATE,
              ResultFolder.REPORT,
              ComparisonFiles.RESULTS.file(),
              ComparisonFiles.METRICS.file(),
              ComparisonFiles.SUMMARY.file(),
              ComparisonFiles.STEPS.file()));
      warnOfDamage(journal);
      Consumer<PrintWriter> summary;
      try (Progress progress = progress(runs.count())) {
        summary = work.write(folder, new JournalledEngine(runEngine, journal, progress));
      }
      InputFiles.write(folder, runs.inputs());
      writeManifest(folder, runs.steps());
      if (runs.hasPage()) {
        folder.write(
            ResultFolder.REPORT,
            Report.html(folder.drafts(), ResultFolder.name(folder.path()), Flags.NOTATION));
      }
      CrateFile.write(folder, runs.inputs());
      ResultFolder.commit(folder, List.of());
      journal.finish(); // last, so that --resume finds all runs after a failure
      return summary;
    }
  }

  private void compute(Shard part, RunEngine runEngine, List<RunPlan> plans) throws IOException {
    List<RunTask> tasks = part.tasks(plans);
    try (OutputFolder folder = screen.folder(out);
        Journal journal = Journal.ofShard(folder, resume);
        Progress progress = progress(tasks.size())) {
      folder.claim(List.of(ResultFolder.MANIFEST));
      warnOfDamage(journal);
      new JournalledEngine(runEngine, journal, progress).run(plans, tasks, (task, run) -> {});
      writeManifest(folder, tasks.stream().mapToLong(task -> plans.get(task.plan()).steps()).sum());
      folder.commit(List.of());
    }
    screen.say("shard %s: %s runs", part, tasks.size());
  }

  void warnOfFewSeeds(int seeds) {
    if (seeds < Estimate.ENOUGH_SEEDS) {
      screen.note(
          "warning: --repeat %d: with fewer than %d seeds intervals are wide or missing, and"
              + " other seeds may give another result",
          seeds, Estimate.ENOUGH_SEEDS);
    }
  }

  private void warnOfDamage(Journal journal) {
    journal
        .damage()
        .map(damage -> "warning: " + Place.printable(damage) + "; its run is computed again")
        .ifPresent(screen.err()::println);
  }

  /** Warns if a policy's claim to be the best is not proven for every step. */
  private void warnOfUnproven(CaseResult result) {
    RunPlan plan = result.plan();
    List<RunResult> results = result.runs().stream().map(ScoredRun::result).toList();
    RunResult.unprovenSteps(plan, results).ifPresent(steps -> warnOfUnproven(plan, " in " + steps));
    RunResult.unprovenExpectation(results).ifPresent(gap -> warnOfUnproven(plan, "; " + gap));
  }

  private void warnOfUnproven(RunPlan plan, String detail) {
    screen.note(
        "warning: scenario %s, detection %s: '%s' is not proven to be the best%s",
        plan.scenario().name(), plan.detection().name(), plan.policy(), detail);
  }

  private Progress progress(long runs) {
    return screen.progress("", " runs", runs);
  }

  private void writeManifest(OutputFolder folder, long steps) throws IOException {
    ManifestFile.write(folder, screen.words(), started, steps);
  }
}
