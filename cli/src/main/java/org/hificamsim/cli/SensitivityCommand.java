package org.hificamsim.cli;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.reproduction.sensitivity.SensitivityFiles;
import org.hificamsim.reproduction.sensitivity.Sweeps;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.ComparisonRun;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Model.CommandSpec;
import picocli.CommandLine.Option;
import picocli.CommandLine.Spec;

/** {@code hificamsim sensitivity}: what each open parameter does to the conclusion of chapter 8. */
@Command(
    name = "sensitivity",
    description = "Sweeps thresholds, targets, gamma, epsilon, k and the reward around defaults.",
    mixinStandardHelpOptions = true,
    showDefaultValues = true)
final class SensitivityCommand implements Callable<Integer> {
  @Option(
      names = "--out",
      paramLabel = "DIR",
      defaultValue = "out/sensitivity",
      description = "Where the files go.")
  private Path out;

  @Option(names = "--steps", paramLabel = "N", defaultValue = "2000", description = "Steps.")
  private int steps;

  @Option(names = "--repeat", paramLabel = "N", defaultValue = "10", description = "Seeds.")
  private int repeats;

  @Mixin private BatchOptions batch;

  @Spec private CommandSpec spec;

  private String findings;

  @Override
  public Integer call() throws IOException {
    batch.check(steps, repeats);
    Catalogue catalogue = Catalogue.load();
    Sweeps sweeps =
        new Sweeps(ShippedScenarios.read(Sweeps.scenarioNames(), catalogue), catalogue::detection);
    Optional<List<CaseResult>> cases =
        new BatchRun(spec, batch, catalogue)
            .execute(
                sweeps.plans(steps, batch.seed(), repeats),
                out,
                ComparisonRun::executeWithoutTables,
                (folder, results) -> findings = SensitivityFiles.write(folder, sweeps, results));
    if (cases.isPresent()) {
      batch.quiet().out(spec).println(findings + "files: " + out);
    }
    return 0;
  }
}
