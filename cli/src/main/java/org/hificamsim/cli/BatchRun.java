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
 * The runs of a command that has many, and the options of all such commands: with progress, a
 * manifest, the page and a summary.
 */
final class BatchRun {
  /** Writes a command's own files. */
  @FunctionalInterface
  interface Files {
    /** Adds them to a folder's, and returns what prints their summary. */
    Consumer<PrintWriter> write(OutputFolder folder, List<CaseResult> results) throws IOException;
  }

  /** Runs what a command needs, and writes its own files. */
  @FunctionalInterface
  interface Work {
    /** The same; the engine keeps finished runs for {@code --resume}. */
    Consumer<PrintWriter> write(OutputFolder folder, RunEngine engine) throws IOException;
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

  /** The threads that were asked for, 1 or more. */
  int threads() {
    return threads.count();
  }

  /** Whether all runs are still to be computed, by this machine. */
  boolean computesHere() {
    return merge == null && !resume && engine.equals(LocalEngine.NAME);
  }

  /** Whether a part of the runs was asked for, or parts are put together. */
  boolean isInParts() {
    return shard.isPresent() || merge != null;
  }

  /**
   * Checks that every plan can start, then runs them all, or the part that was asked for.
   *
   * @param references what is run in addition to the command's plans
   * @param files the command's own; not those of a part, which wait to be merged
   * @return the exit code
   * @throws InputException when a plan cannot start; nothing was written then
   */
  int execute(
      Screen on,
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
    return execute(on, catalogue, all, all, steps, true, work);
  }

  /**
   * Checks that every plan can start, then has the work done, or a part of its runs.
   *
   * @param all whose runs a shard has a part of
   * @param inputs plans with each scenario and detection, for the files about what was run
   * @param steps of all runs, at most
   * @param page whether the page is made too
   * @return the exit code
   * @throws InputException when a plan cannot start, there is no such engine, it cannot work, or
   *     shards are missing; nothing was written then
   */
  int execute(
      Screen on,
      Catalogue catalogue,
      List<RunPlan> all,
      List<RunPlan> inputs,
      long steps,
      boolean page,
      Work work)
      throws IOException {
    screen = on;
    all.forEach(new RunExecutor(catalogue)::check);
    if (shard.isPresent() && merge != null) {
      throw new InputException("--shard and --merge are given, expected one of them");
    }
    Optional<Shard> part = shard.map(Shard::parse);
    RunEngine computing = RunEngine.registry().create(engine);
    if (merge == null) {
      computing.configure(new EngineSettings(catalogue, threads(), master));
    } else {
      computing = new MergedShards(merge, all);
    }
    if (part.isPresent()) {
      compute(part.get(), computing, all);
    } else {
      whole(computing, inputs, runs(all, steps), steps, page, work).accept(screen.out());
    }
    screen.out().println("files: " + out);
    return 0;
  }

  /** Of plans whose scenarios may differ in steps; more where a search adds runs to them. */
  static long runs(List<RunPlan> all, long steps) {
    int longest = all.stream().mapToInt(RunPlan::steps).max().orElse(1);
    return Math.max(all.stream().mapToLong(RunPlan::repeats).sum(), steps / longest);
  }

  private Consumer<PrintWriter> whole(
      RunEngine computing, List<RunPlan> inputs, long runs, long steps, boolean page, Work work)
      throws IOException {
    try (OutputFolder folder = screen.folder(out);
        Journal journal = Journal.open(folder, Journal.NAME, resume)) {
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
      try (Progress progress = progress(runs)) {
        summary = work.write(folder, new JournalledEngine(computing, journal, progress));
      }
      InputFiles.write(folder, inputs);
      manifest(folder, steps);
      if (page) {
        folder.write(
            ResultFolder.REPORT,
            Report.html(folder.drafts(), ResultFolder.name(folder.path()), Flags.NOTATION));
      }
      CrateFile.write(folder, inputs);
      ResultFolder.commit(folder, List.of());
      journal.finish(); // until here, --resume has all runs
      return summary;
    }
  }

  private void compute(Shard part, RunEngine computing, List<RunPlan> all) throws IOException {
    List<RunTask> tasks = part.tasks(all);
    try (OutputFolder folder = screen.folder(out);
        Journal journal = Journal.ofShard(folder, resume);
        Progress progress = progress(tasks.size())) {
      folder.claim(List.of(ResultFolder.MANIFEST));
      warnOfDamage(journal);
      new JournalledEngine(computing, journal, progress).run(all, tasks, (task, run) -> {});
      manifest(folder, tasks.stream().mapToLong(task -> all.get(task.plan()).steps()).sum());
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

  /** Says so where a policy's claim to be the best is not proven for every step. */
  private void warnOfUnproven(CaseResult one) {
    RunPlan plan = one.plan();
    List<RunResult> results = one.runs().stream().map(ScoredRun::result).toList();
    RunResult.unprovenSteps(plan, results).ifPresent(steps -> warnOfUnproven(plan, " in " + steps));
    RunResult.unprovenExpectation(results).ifPresent(more -> warnOfUnproven(plan, "; " + more));
  }

  private void warnOfUnproven(RunPlan plan, String what) {
    screen.note(
        "warning: scenario %s, detection %s: '%s' is not proven to be the best%s",
        plan.scenario().name(), plan.detection().name(), plan.policy(), what);
  }

  private Progress progress(long runs) {
    return screen.progress("", " runs", runs);
  }

  private void manifest(OutputFolder folder, long steps) throws IOException {
    ManifestFile.write(folder, screen.words(), started, steps);
  }
}
