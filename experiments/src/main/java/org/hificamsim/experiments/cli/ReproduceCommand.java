package org.hificamsim.experiments.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.nio.file.Path;
import java.time.Instant;
import java.util.List;
import java.util.concurrent.Callable;
import org.hificamsim.experiments.catalogue.Catalogue;
import org.hificamsim.experiments.compare.Comparison;
import org.hificamsim.experiments.compare.ComparisonRun;
import org.hificamsim.experiments.output.ManifestFile;
import org.hificamsim.experiments.reproduce.Judgement;
import org.hificamsim.experiments.reproduce.Preset;
import org.hificamsim.experiments.reproduce.ReproductionFiles;
import org.hificamsim.experiments.run.RunExecutor;
import org.hificamsim.experiments.run.RunPlan;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code hificamsim reproduce}: the thesis's Table 8.1, figures and statements, judged. */
@Command(
    name = "reproduce",
    description = "Computes Table 8.1 and Figures 7.3 to 8.1 anew, beside what was published.",
    mixinStandardHelpOptions = true,
    showDefaultValues = true)
final class ReproduceCommand implements Callable<Integer> {
  @Option(
      names = "--out",
      paramLabel = "DIR",
      defaultValue = "out/reproduce",
      description = "Where the files go.")
  private Path out;

  @Option(names = "--steps", paramLabel = "N", defaultValue = "10000", description = "Steps.")
  private int steps;

  @Option(names = "--repeat", paramLabel = "N", defaultValue = "30", description = "Seeds.")
  private int repeats;

  @Mixin private BatchOptions batch;

  @Spec private CommandSpec spec;

  private Judgement judgement;

  @Override
  public Integer call() throws IOException {
    Instant started = Instant.now();
    batch.check(steps, repeats);
    Catalogue catalogue = Catalogue.load();
    Preset preset =
        new Preset(
            ShippedScenarios.read(Preset.scenarioNames(), catalogue), steps, batch.seed(), repeats);
    execute(preset.plans(catalogue::detection), new RunExecutor(catalogue), started);
    JudgementTable.print(spec.commandLine().getOut(), judgement, out);
    return 0;
  }

  private void execute(List<RunPlan> plans, RunExecutor executor, Instant started)
      throws IOException {
    int runs = Comparison.withOptimum(plans).size() * repeats;
    PrintWriter err = spec.commandLine().getErr();
    try (Progress progress = new Progress("reproduce", " runs", runs, err)) {
      Comparison comparison = new Comparison(executor, batch.threads(), progress::advance);
      new ComparisonRun(comparison, batch.resume())
          .execute(
              plans,
              out,
              (folder, results) -> {
                judgement = ReproductionFiles.write(folder, results);
                ManifestFile.write(
                    folder.open("manifest.json"),
                    spec.commandLine().getParent().getParseResult().originalArgs(),
                    started,
                    (long) runs * steps);
              });
    }
  }
}
