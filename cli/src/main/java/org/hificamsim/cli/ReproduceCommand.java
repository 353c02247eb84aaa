package org.hificamsim.cli;

import java.io.IOException;
import java.io.PrintWriter;
import java.util.List;
import java.util.Locale;
import java.util.concurrent.Callable;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.Texts;
import org.hificamsim.reproduction.AdaptingValue;
import org.hificamsim.reproduction.Distance;
import org.hificamsim.reproduction.FitRole;
import org.hificamsim.reproduction.JudgedClaim;
import org.hificamsim.reproduction.Judgement;
import org.hificamsim.reproduction.Reading;
import org.hificamsim.reproduction.ReproductionFiles;
import org.hificamsim.reproduction.ReproductionPlans;
import org.hificamsim.reproduction.Table81;
import org.hificamsim.reproduction.Verdict;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.compare.ComparisonFiles;
import org.hificamsim.runs.compare.ReferencePolicies;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;

/** {@code hificamsim reproduce}: judges Table 8.1, figures and statements of the thesis. */
@Command(
    name = "reproduce",
    description =
        "Computes the thesis's Table 8.1 and Figures 7.3 to 8.1, next to the published numbers.")
final class ReproduceCommand implements Callable<Integer> {
  @Mixin private BatchRun batch;

  @Mixin private Screen screen;

  @Mixin
  private final SettingOptions settings =
      SettingOptions.of(Setting.STEPS, Setting.REPEAT, Setting.SEED);

  @Override
  public Integer call() throws IOException {
    Catalogue catalogue = Catalogue.load();
    ReproductionPlans reproduction =
        new ReproductionPlans(
            ShippedScenarios.read(ReproductionPlans.scenarioNames(), catalogue),
            settings.settings());
    List<RunPlan> plans = reproduction.plans(catalogue::detection);
    return batch.execute(
        screen,
        catalogue,
        ReferencePolicies.OPTIMUM,
        plans,
        (folder, results) -> {
          ComparisonFiles.write(folder, results.subList(0, plans.size()), results);
          Judgement judgement = ReproductionFiles.write(folder, results);
          return out -> print(out, judgement);
        });
  }

  private static void print(PrintWriter out, Judgement judgement) {
    out.println(AdaptingValue.finding(judgement.adapting()));
    out.println();
    out.printf(
        "%-8s %-15s %-9s %9s  %-20s %7s %6s  %-8s %s%n",
        "layout",
        "policy",
        "detection",
        "published",
        "ours [95%]",
        "one-hop",
        "Eq 6.2",
        "role",
        "verdict");
    for (Table81.Cell cell : judgement.cells()) {
      out.printf(
          Locale.ROOT,
          "%-8s %-15s %-9s %9.2f  %-20s %7s %6s  %-8s %s%n",
          cell.published().layout().label(),
          cell.published().policy(),
          cell.published().hifi() ? "hi-fi" : "CamSim",
          cell.published().proportion(),
          cell.ours().text("%.3f"),
          text(cell, Reading.ONE_HOP_GREEDY),
          text(cell, Reading.EQ_62),
          cell.role().label(),
          cell.verdict().label());
    }
    out.println();
    printDistances(out, judgement.distances());
    out.println();
    for (JudgedClaim statement : judgement.statements()) {
      out.printf(
          "%-15s %-8s %s%n",
          statement.verdict().label(), statement.role().label(), statement.text());
    }
    out.println();
    for (FitRole role : FitRole.values()) {
      out.printf("%-15s %s%n", role.label(), judgement.score(role));
    }
    for (Verdict verdict : Verdict.values()) {
      out.printf("%-15s %s%n", verdict.label(), judgement.score(verdict));
    }
  }

  private static String text(Table81.Cell cell, Reading reading) {
    return Double.isNaN(cell.proportion(reading))
        ? ""
        : Texts.format("%.2f", cell.proportion(reading));
  }

  /** Prints a line for each reading with the distances of the hi-fi column and of CamSim's. */
  private static void printDistances(PrintWriter out, List<Distance> distances) {
    Distance first = distances.get(0);
    out.printf(
        Locale.ROOT,
        "mean distance from the published cells, and cells within 0.05 of them (%d steps, %d"
            + " seeds):%n%-26s %-15s %s%n",
        first.steps(),
        first.seeds(),
        "reading",
        "hi-fi",
        "CamSim");
    for (int i = 0; i < distances.size(); i += 2) {
      out.printf(
          "%-26s %-15s %s%n",
          distances.get(i).label(), text(distances.get(i)), text(distances.get(i + 1)));
    }
    out.println(
        "default divides by the best of all configurations, over_one_hop by the best within one"
            + " zoom level.");
  }

  private static String text(Distance distance) {
    return Texts.format("%.3f, %d of 9", distance.mean(), distance.nearCells());
  }
}
