package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.time.Instant;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import java.util.function.BiConsumer;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.presentation.report.Report;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Comparison;
import org.hificamsim.runs.compare.ComparisonRun;
import org.hificamsim.runs.compare.RunEngine;
import org.hificamsim.runs.compare.Shard;
import org.hificamsim.runs.compare.ShardRun;
import org.hificamsim.runs.compare.Yardsticks;
import org.hificamsim.runs.output.CrateFile;
import org.hificamsim.runs.output.InputFiles;
import org.hificamsim.runs.output.ManifestFile;
import org.hificamsim.runs.output.ResultFolder;

/** The runs of a command that has many: with progress, a manifest, the page and a summary. */
final class BatchRun {
  /** How a comparison makes files of its plans. */
  @FunctionalInterface
  interface Writing {
    /** Runs all plans and writes what they gave, the extras among it. */
    List<CaseResult> execute(
        ComparisonRun comparison,
        List<RunPlan> plans,
        OutputFolder folder,
        ComparisonRun.Extras extras)
        throws IOException;
  }

  private final Screen screen;
  private final BatchOptions options;
  private final Catalogue catalogue;
  private final Yardsticks yardsticks;
  private final Instant started = Instant.now();

  /** Runs with the optimum beside them. */
  BatchRun(Screen screen, BatchOptions options, Catalogue catalogue) {
    this(screen, options, catalogue, Yardsticks.OPTIMUM);
  }

  /**
   * @param yardsticks what is run beside the command's plans
   */
  BatchRun(Screen screen, BatchOptions options, Catalogue catalogue, Yardsticks yardsticks) {
    this.screen = screen;
    this.options = options;
    this.catalogue = catalogue;
    this.yardsticks = yardsticks;
  }

  /**
   * Checks that every plan can start, then runs them all, or the part that was asked for.
   *
   * @param writing {@link ComparisonRun#execute} or its like without tables
   * @param extras the command's own files; the manifest is added to them
   * @param summary prints the results; not those of a part, which wait to be merged
   * @return the exit code
   * @throws org.hificamsim.core.InputException when a plan cannot start; nothing was written then
   */
  int execute(
      List<RunPlan> plans,
      Writing writing,
      ComparisonRun.Extras extras,
      BiConsumer<PrintWriter, List<CaseResult>> summary)
      throws IOException {
    plans.forEach(new RunExecutor(catalogue)::check);
    Optional<Shard> shard = options.shard();
    List<RunPlan> all = yardsticks.with(plans);
    RunEngine engine = options.engine(catalogue, all);
    if (shard.isPresent()) {
      part(shard.get(), engine, all);
    } else {
      List<CaseResult> results = whole(engine, plans, all, writing, extras);
      results.forEach(this::warnOfUnproven);
      summary.accept(screen.out(), results);
    }
    screen.out().println("files: " + options.out());
    return 0;
  }

  private List<CaseResult> whole(
      RunEngine engine,
      List<RunPlan> plans,
      List<RunPlan> all,
      Writing writing,
      ComparisonRun.Extras extras)
      throws IOException {
    long steps = all.stream().mapToLong(plan -> (long) plan.repeats() * plan.steps()).sum();
    try (OutputFolder folder = new OutputFolder(options.out());
        Progress progress = progress(all.stream().mapToLong(RunPlan::repeats).sum())) {
      Comparison comparison = new Comparison(engine, progress);
      return writing.execute(
          new ComparisonRun(comparison, yardsticks, options.resume(), () -> describe(folder, all)),
          plans,
          folder,
          (files, results) -> {
            extras.write(files, results);
            InputFiles.write(files, all);
            manifest(files, steps);
          });
    }
  }

  /** The page of the files that are in their place, and the crate that names them all. */
  private static void describe(OutputFolder folder, List<RunPlan> all) throws IOException {
    Report.write(folder.path(), folder.path().resolve(ResultFolder.REPORT));
    CrateFile.write(folder.path(), folder.written(), List.of(ResultFolder.REPORT), all);
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
          String.format(
              Locale.ROOT, "; the least expected k of a step might be up to %.3g higher", gap));
    }
  }

  private void warnOfUnproven(RunPlan plan, String what) {
    screen
        .err()
        .printf(
            "warning: scenario %s, detection %s: '%s' is not proven to be the best%s%n",
            plan.scenario().name(), plan.detection().name(), plan.policy(), what);
  }

  private void part(Shard shard, RunEngine engine, List<RunPlan> all) throws IOException {
    ShardRun run = new ShardRun(shard, all);
    try (Progress progress = progress(run.runs())) {
      run.execute(
          engine,
          options.resume(),
          progress,
          options.out(),
          folder -> manifest(folder, run.steps()));
    }
    screen.out().printf("shard %s: %s runs%n", shard, run.runs());
  }

  private Progress progress(long runs) {
    return screen.progress("", " runs", runs);
  }

  private void manifest(OutputFolder folder, long steps) throws IOException {
    ManifestFile.write(folder, screen.words(), started, steps);
  }
}
