package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Place;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.presentation.report.Report;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Comparison;
import org.hificamsim.runs.compare.ComparisonFiles;
import org.hificamsim.runs.compare.Journal;
import org.hificamsim.runs.compare.JournalledEngine;
import org.hificamsim.runs.compare.ReferencePolicies;
import org.hificamsim.runs.compare.RunEngine;
import org.hificamsim.runs.compare.RunTask;
import org.hificamsim.runs.compare.Shard;
import org.hificamsim.runs.output.CrateFile;
import org.hificamsim.runs.output.InputFiles;
import org.hificamsim.runs.output.ManifestFile;
import org.hificamsim.runs.output.ResultFolder;

/** The runs of a command that has many: with progress, a manifest, the page and a summary. */
final class BatchRun {
  /**
   * Writes a command's own files.
   *
   * @param <R> what its summary is made of
   */
  @FunctionalInterface
  interface Files<R> {
    /** Adds them to a folder's. */
    R write(OutputFolder folder, List<CaseResult> results) throws IOException;
  }

  /**
   * Runs what a command needs, and writes its own files.
   *
   * @param <R> what its summary is made of
   */
  @FunctionalInterface
  interface Work<R> {
    /** Adds them to a folder's; the engine keeps finished runs for {@code --resume}. */
    R write(OutputFolder folder, RunEngine engine) throws IOException;
  }

  private final Screen screen;
  private final BatchOptions options;
  private final Catalogue catalogue;
  private final ReferencePolicies references;
  private final Instant started = Instant.now();

  /**
   * @param references what is run in addition to the command's plans
   */
  BatchRun(Screen screen, BatchOptions options, Catalogue catalogue, ReferencePolicies references) {
    this.screen = screen;
    this.options = options;
    this.catalogue = catalogue;
    this.references = references;
  }

  /**
   * Checks that every plan can start, then runs them all, or the part that was asked for.
   *
   * @param files the command's own
   * @param summary prints the results; not those of a part, which wait to be merged
   * @return the exit code
   * @throws org.hificamsim.core.InputException when a plan cannot start; nothing was written then
   */
  <R> int execute(List<RunPlan> plans, Files<R> files, BiConsumer<PrintWriter, R> summary)
      throws IOException {
    List<RunPlan> all = references.with(plans);
    long steps = all.stream().mapToLong(RunPlan::work).sum();
    Work<R> work =
        (folder, engine) -> {
          List<CaseResult> results = Comparison.run(plans, references, engine);
          warnOfFewSeeds(plans.get(0).repeats());
          results.forEach(this::warnOfUnproven);
          return files.write(folder, results);
        };
    return execute(all, all, steps, true, work, summary);
  }

  /**
   * Checks that every plan can start, then has the work done, or a part of its runs.
   *
   * @param all whose runs a shard has a part of
   * @param inputs plans with each scenario and detection, for the files about what was run
   * @param steps of all runs, at most
   * @param page whether the page is made too
   * @return the exit code
   * @throws org.hificamsim.core.InputException when a plan cannot start; nothing was written then
   */
  <R> int execute(
      List<RunPlan> all,
      List<RunPlan> inputs,
      long steps,
      boolean page,
      Work<R> work,
      BiConsumer<PrintWriter, R> summary)
      throws IOException {
    all.forEach(new RunExecutor(catalogue)::check);
    Optional<Shard> shard = options.shard();
    RunEngine engine = options.engine(catalogue, all);
    if (shard.isPresent()) {
      part(shard.get(), engine, all);
    } else {
      summary.accept(screen.out(), whole(engine, inputs, runs(all, steps), steps, page, work));
    }
    screen.out().println("files: " + options.out());
    return 0;
  }

  /** Of plans whose scenarios may differ in steps; more where a search adds runs to them. */
  static long runs(List<RunPlan> all, long steps) {
    int longest = all.stream().mapToInt(RunPlan::steps).max().orElse(1);
    return Math.max(all.stream().mapToLong(RunPlan::repeats).sum(), steps / longest);
  }

  private <R> R whole(
      RunEngine engine, List<RunPlan> inputs, long runs, long steps, boolean page, Work<R> work)
      throws IOException {
    try (OutputFolder folder = screen.folder(options.out());
        Journal journal = Journal.open(folder, Journal.NAME, options.resume())) {
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
      R written;
      try (Progress progress = progress(runs)) {
        written = work.write(folder, new JournalledEngine(engine, journal, progress));
      }
      InputFiles.write(folder, inputs);
      manifest(folder, steps);
      if (page) {
        folder.write(
            ResultFolder.REPORT, Report.html(folder.drafts(), ResultFolder.name(folder.path())));
      }
      CrateFile.write(folder, inputs);
      ResultFolder.commit(folder, List.of());
      journal.finish(); // until here, --resume has all runs
      return written;
    }
  }

  private void part(Shard shard, RunEngine engine, List<RunPlan> all) throws IOException {
    List<RunTask> tasks = shard.tasks(all);
    try (OutputFolder folder = screen.folder(options.out());
        Journal journal = Journal.ofShard(folder, options.resume());
        Progress progress = progress(tasks.size())) {
      folder.claim(List.of(ResultFolder.MANIFEST));
      warnOfDamage(journal);
      new JournalledEngine(engine, journal, progress).run(all, tasks, (task, run) -> {});
      manifest(folder, tasks.stream().mapToLong(task -> all.get(task.plan()).steps()).sum());
      folder.commit(List.of());
    }
    screen.say("shard %s: %s runs", shard, tasks.size());
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
    if (one.proof().unprovenSteps() > 0) {
      long steps = (long) one.plan().steps() * one.plan().repeats();
      warnOfUnproven(one.plan(), " in " + one.proof().missing(steps, one.plan().objective()));
    }
    double gap = one.runs().stream().mapToDouble(run -> run.result().expectedGap()).max().orElse(0);
    if (gap > 0) {
      warnOfUnproven(
          one.plan(),
          Texts.format("; the least expected k of a step might be up to %.3g higher", gap));
    }
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
