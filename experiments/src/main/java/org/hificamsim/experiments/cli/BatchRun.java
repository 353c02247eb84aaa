package org.hificamsim.experiments.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import org.hificamsim.experiments.catalogue.Catalogue;
import org.hificamsim.experiments.compare.CaseResult;
import org.hificamsim.experiments.compare.Comparison;
import org.hificamsim.experiments.compare.ComparisonRun;
import org.hificamsim.experiments.output.ManifestFile;
import org.hificamsim.experiments.run.RunExecutor;
import org.hificamsim.experiments.run.RunPlan;
import picocli.CommandLine.Model.CommandSpec;

/** The runs of a command that has many: with progress on standard error and a manifest. */
final class BatchRun {
  /** How a comparison makes files of its plans. */
  @FunctionalInterface
  interface Writing {
    /** Runs all plans and writes what they gave, the extras among it. */
    List<CaseResult> execute(
        ComparisonRun comparison, List<RunPlan> plans, Path out, ComparisonRun.Extras extras)
        throws IOException;
  }

  private final CommandSpec command;
  private final BatchOptions options;
  private final RunExecutor executor;
  private final Instant started = Instant.now();

  BatchRun(CommandSpec command, BatchOptions options, Catalogue catalogue) {
    this.command = command;
    this.options = options;
    this.executor = new RunExecutor(catalogue);
  }

  /**
   * Checks that every plan can start, then runs them all.
   *
   * @param writing {@link ComparisonRun#execute} or its like without tables
   * @param extras the command's own files; the manifest is added to them
   * @throws org.hificamsim.core.InputException when a plan cannot start; nothing was written then
   */
  List<CaseResult> execute(
      List<RunPlan> plans, Path out, Writing writing, ComparisonRun.Extras extras)
      throws IOException {
    plans.forEach(executor::check);
    List<RunPlan> all = Comparison.withOptimum(plans);
    long runs = all.stream().mapToLong(RunPlan::repeats).sum();
    long steps = all.stream().mapToLong(plan -> (long) plan.repeats() * plan.steps()).sum();
    try (Progress progress = options.quiet().progress(command, command.name(), " runs", runs)) {
      Comparison comparison = new Comparison(executor, options.threads(), progress::advance);
      return writing.execute(
          new ComparisonRun(comparison, options.resume()),
          plans,
          out,
          (folder, results) -> {
            extras.write(folder, results);
            ManifestFile.write(
                folder.open("manifest.json"),
                command.commandLine().getParent().getParseResult().originalArgs(),
                started,
                steps);
          });
    }
  }
}
