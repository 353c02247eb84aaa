package org.hificamsim.cli;

import java.io.IOException;
import java.util.List;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.reproduction.ReproductionFiles;
import org.hificamsim.reproduction.ReproductionPlans;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.compare.ComparisonFiles;
import org.hificamsim.runs.compare.ReferencePolicies;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code hificamsim reproduce}: the thesis's Table 8.1, figures and statements, judged. */
@Command(
    name = "reproduce",
    description = "Computes Table 8.1 and Figures 7.3 to 8.1 again, beside what was published.")
final class ReproduceCommand implements Callable<Integer> {
  @Mixin private BatchOptions batch;

  @Mixin private Screen screen;

  @Mixin
  private final SettingOptions settings =
      SettingOptions.of(Setting.STEPS, Setting.REPEAT, Setting.SEED);

  @Override
  public Integer call() throws IOException {
    Catalogue catalogue = Catalogue.load();
    ReproductionPlans preset =
        new ReproductionPlans(
            ShippedScenarios.read(ReproductionPlans.scenarioNames(), catalogue),
            settings.settings());
    List<RunPlan> plans = preset.plans(catalogue::detection);
    return new BatchRun(screen, batch, catalogue, ReferencePolicies.OPTIMUM)
        .execute(
            plans,
            (folder, results) -> {
              ComparisonFiles.write(folder, results.subList(0, plans.size()), results);
              return ReproductionFiles.write(folder, results);
            },
            JudgementTable::print);
  }
}
