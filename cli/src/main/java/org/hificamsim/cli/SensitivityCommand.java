package org.hificamsim.cli;

import java.io.IOException;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.reproduction.sensitivity.SensitivityFiles;
import org.hificamsim.reproduction.sensitivity.Sweeps;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.compare.ReferencePolicies;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code hificamsim sensitivity}: shows how open parameters change the conclusion of chapter 8. */
@Command(
    name = "sensitivity",
    description =
        "Shows what chapter 8 depends on: varies thresholds, targets, radii, optics, f, g, CamSim's"
            + " formula, the reading of greedy and the learners' settings, one at a time.")
final class SensitivityCommand implements Callable<Integer> {
  @Mixin private BatchRun batch;

  @Mixin private Screen screen;

  @Mixin
  private final SettingOptions settings =
      SettingOptions.of(Setting.STEPS, Setting.REPEAT, Setting.SEED);

  @Override
  public Integer call() throws IOException {
    Catalogue catalogue = Catalogue.load();
    Sweeps sweeps =
        new Sweeps(ShippedScenarios.read(Sweeps.scenarioNames(), catalogue), catalogue::detection);
    return batch.execute(
        screen,
        catalogue,
        ReferencePolicies.OPTIMUM,
        sweeps.plans(settings.settings()),
        (folder, results) -> {
          String summary = SensitivityFiles.write(folder, sweeps, results);
          return out -> out.print(summary);
        });
  }
}
