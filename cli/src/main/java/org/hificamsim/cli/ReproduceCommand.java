package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.reproduction.Judgement;
import org.hificamsim.reproduction.Preset;
import org.hificamsim.reproduction.ReproductionFiles;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.ComparisonRun;
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
    batch.check(steps, repeats);
    Catalogue catalogue = Catalogue.load();
    Preset preset =
        new Preset(
            ShippedScenarios.read(Preset.scenarioNames(), catalogue), steps, batch.seed(), repeats);
    Optional<List<CaseResult>> cases =
        new BatchRun(spec, batch, catalogue)
            .execute(
                preset.plans(catalogue::detection),
                out,
                ComparisonRun::execute,
                (folder, results) -> judgement = ReproductionFiles.write(folder, results));
    if (cases.isPresent()) {
      JudgementTable.print(batch.quiet().out(spec), judgement, out);
    }
    return 0;
  }
}
