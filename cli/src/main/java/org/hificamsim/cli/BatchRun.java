package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.Optional;
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
import org.hificamsim.runs.output.ManifestFile;
import org.hificamsim.runs.output.ResultFolder;
import picocli.CommandLine.Model.CommandSpec;

/** The runs of a command that has many: with progress on standard error and a manifest. */
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

  private final CommandSpec command;
  private final BatchOptions options;
  private final Catalogue catalogue;
  private final Instant started = Instant.now();

  BatchRun(CommandSpec command, BatchOptions options, Catalogue catalogue) {
    this.command = command;
    this.options = options;
    this.catalogue = catalogue;
  }

  /**
   * Checks that every plan can start, then runs them all, or the part that was asked for.
   *
   * @param writing {@link ComparisonRun#execute} or its like without tables
   * @param extras the command's own files; the manifest is added to them
   * @return one result per plan, or nothing when they are a part's and wait to be merged
   * @throws org.hificamsim.core.InputException when a plan cannot start; nothing was written then
   */
  Optional<List<CaseResult>> execute(
      List<RunPlan> plans, Path out, Writing writing, ComparisonRun.Extras extras)
      throws IOException {
    plans.forEach(new RunExecutor(catalogue)::check);
    Optional<Shard> shard = options.shard();
    List<RunPlan> all = Comparison.withOptimum(plans);
    RunEngine engine = options.engine(catalogue, all);
    if (shard.isPresent()) {
      part(shard.get(), engine, all, out);
      return Optional.empty();
    }
    List<CaseResult> results = whole(engine, plans, out, writing, extras);
    results.forEach(this::tellUnproven);
    return Optional.of(results);
  }

  private List<CaseResult> whole(
      RunEngine engine, List<RunPlan> plans, Path out, Writing writing, ComparisonRun.Extras extras)
      throws IOException {
    List<RunPlan> all = Comparison.withOptimum(plans);
    long steps = all.stream().mapToLong(plan -> (long) plan.repeats() * plan.steps()).sum();
    try (OutputFolder folder = new OutputFolder(out);
        Progress progress = progress(all.stream().mapToLong(RunPlan::repeats).sum())) {
      Comparison comparison = new Comparison(engine, progress::advance);
      List<CaseResult> cases =
          writing.execute(
              new ComparisonRun(comparison, options.resume()),
              plans,
              folder,
              (files, results) -> {
                extras.write(files, results);
                manifest(files, steps);
              });
      Report.write(out, out.resolve(ResultFolder.REPORT));
      return cases;
    }
  }

  /** Says so where a policy's claim to be the best is not proven for every step. */
  private void tellUnproven(CaseResult one) {
    if (one.proof().unprovenSteps() > 0) {
      RunPlan plan = one.plan();
      options
          .quiet()
          .err(command)
          .printf(
              "warning: scenario %s, detection %s: '%s' is not proven to be the best in %s%n",
              plan.scenario().name(),
              plan.detection().name(),
              plan.policy(),
              one.proof().missing((long) plan.steps() * plan.repeats()));
    }
  }

  private void part(Shard shard, RunEngine engine, List<RunPlan> all, Path out) throws IOException {
    ShardRun run = new ShardRun(shard, all);
    try (Progress progress = progress(run.runs())) {
      run.execute(
          engine,
          options.resume(),
          progress::advance,
          out,
          folder -> manifest(folder, run.steps()));
    }
    options
        .quiet()
        .out(command)
        .println("shard %s: %d runs\nfiles: %s".formatted(shard, run.runs(), out));
  }

  private Progress progress(long runs) {
    return options.quiet().progress(command, command.name(), " runs", runs);
  }

  private void manifest(OutputFolder folder, long steps) throws IOException {
    ManifestFile.write(
        folder, command.commandLine().getParent().getParseResult().originalArgs(), started, steps);
  }
}
