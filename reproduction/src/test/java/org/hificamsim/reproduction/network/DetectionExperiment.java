package org.hificamsim.reproduction.network;

import java.awt.Color;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.function.ToDoubleFunction;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.detection.Detection;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.network.CamSimScenario;
import org.hificamsim.network.NetworkRun;
import org.hificamsim.network.NetworkSettings;
import org.hificamsim.network.Strategy;
import org.hificamsim.network.agent.ScheduleKind;
import org.hificamsim.network.statistics.StepFigures;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.StackPanel;
import org.hificamsim.runs.output.Table;
import org.knowm.xchart.CategoryChart;

/**
 * Runs the experiment of {@code docs/camsim-network.md}: how handovers and communication change if
 * bids come from a hi-fi model instead of CamSim's visibility.
 */
public final class DetectionExperiment {
  private static final int STEPS = 1000;
  private static final int SEEDS = 10;
  private static final List<String> DETECTIONS = List.of("camsim-visibility", "hifi:orb-lin");
  private static final List<Color> COLORS = List.of(Palette.GREY, Palette.BLUE);
  private static final List<Setting> SETTINGS =
      List.of(
          new Setting(ScheduleKind.ACTIVE, 0),
          new Setting(ScheduleKind.ACTIVE, 1),
          new Setting(ScheduleKind.PASSIVE, 0),
          new Setting(ScheduleKind.PASSIVE, 1));

  private final Catalogue catalogue = Catalogue.load();

  private record Setting(ScheduleKind schedule, int comm) {
    String label() {
      return schedule.names().get(0) + " c" + comm;
    }
  }

  /** The sums of a run, as means over the seeds. */
  private record Outcome(
      String scenario,
      String detection,
      String setting,
      double messages,
      double handovers,
      double tracked,
      double utility) {}

  private DetectionExperiment() {}

  /**
   * Writes {@code camsim-network.csv} and {@code camsim-network.png}.
   *
   * @param args the folder, then the scenario files
   */
  public static void main(String[] args) throws IOException {
    DetectionExperiment experiment = new DetectionExperiment();
    List<Path> files = Arrays.stream(args).skip(1).map(Path::of).toList();
    List<Outcome> outcomes = new ArrayList<>();
    for (Path file : files) {
      for (String detection : DETECTIONS) {
        SETTINGS.forEach(setting -> outcomes.add(experiment.run(file, detection, setting)));
      }
    }
    try (OutputFolder folder = new OutputFolder(Path.of(args[0]))) {
      table(folder, outcomes);
      try (OutputStream out = folder.stream("camsim-network.png")) {
        FigureFile.png(out, figure(outcomes));
      }
      folder.commit(List.of());
    }
  }

  private Outcome run(Path file, String detection, Setting setting) {
    List<StepFigures> runs = new ArrayList<>();
    for (int seed = 0; seed < SEEDS; seed++) {
      runs.add(run(file, detection, setting, seed));
    }
    return new Outcome(
        name(file),
        detection,
        setting.label(),
        mean(runs, StepFigures::communication),
        mean(runs, StepFigures::handovers),
        mean(runs, StepFigures::meanProportion),
        mean(runs, StepFigures::utility));
  }

  private StepFigures run(Path file, String detection, Setting setting, int seed) {
    NetworkSettings settings =
        NetworkSettings.CAMSIM.withStrategies(
            List.of(new Strategy(setting.schedule(), setting.comm())));
    PrintWriter nowhere =
        new PrintWriter(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
    Scenario scenario = CamSimScenario.read(file, null, false, settings, catalogue, nowhere);
    Detection model = Detection.of(catalogue.detection(detection));
    ZoomPolicy zooms = catalogue.policies().create("zoom-out");
    return new NetworkRun(scenario, model, zooms, catalogue.movements(), settings, seed).run(STEPS);
  }

  private static double mean(List<StepFigures> runs, ToDoubleFunction<StepFigures> figure) {
    return runs.stream().mapToDouble(figure).average().orElse(0);
  }

  /** The name of a file with its folder, which distinguishes files of CamSim's collection. */
  private static String name(Path file) {
    return file.getName(file.getNameCount() - 2)
        + "/"
        + file.getFileName().toString().replace(".xml", "");
  }

  private static void table(OutputFolder folder, List<Outcome> outcomes) throws IOException {
    Table.<Outcome>of("camsim-network.csv")
        .texts("scenario", "", Outcome::scenario)
        .texts("detection", "", Outcome::detection)
        .texts("setting", "", Outcome::setting)
        .doubles("messages", "", "", Outcome::messages)
        .doubles("handovers", "", "", Outcome::handovers)
        .doubles("tracked", "", "", outcome -> rounded(outcome.tracked()))
        .doubles("utility", "", "", outcome -> rounded(outcome.utility()))
        .write(folder, outcomes.stream());
  }

  private static double rounded(double value) {
    return Double.parseDouble(String.format(Locale.ROOT, "%.4f", value));
  }

  private static Figure figure(List<Outcome> outcomes) {
    List<String> scenarios = outcomes.stream().map(Outcome::scenario).distinct().toList();
    List<CategoryChart> panels = new ArrayList<>();
    scenarios.forEach(name -> panels.add(panel(outcomes, name, "handovers", Outcome::handovers)));
    scenarios.forEach(
        name ->
            panels.add(
                panel(outcomes, name, "messages (1000)", outcome -> outcome.messages() / 1000)));
    List<LegendEntry> legend = new ArrayList<>();
    for (int i = 0; i < COLORS.size(); i++) {
      legend.add(new LegendEntry(DETECTIONS.get(i), COLORS.get(i), LegendEntry.Mark.BAR));
    }
    return new Figure(
        "Handovers and communication by detection model",
        STEPS + " steps, mean over " + SEEDS + " seeds. c0 Broadcast, c1 Smooth.",
        legend,
        panels,
        scenarios.size(),
        250,
        210);
  }

  private static CategoryChart panel(
      List<Outcome> outcomes, String scenario, String unit, ToDoubleFunction<Outcome> figure) {
    StackPanel panel =
        new StackPanel(scenario, unit, SETTINGS.stream().map(Setting::label).toList());
    double most = 0;
    for (int i = 0; i < COLORS.size(); i++) {
      String detection = DETECTIONS.get(i);
      List<Double> values =
          outcomes.stream()
              .filter(
                  outcome ->
                      outcome.scenario().equals(scenario) && outcome.detection().equals(detection))
              .map(figure::applyAsDouble)
              .toList();
      most = values.stream().reduce(most, Math::max);
      panel.layer(values, COLORS.get(i));
    }
    panel.getStyler().setStacked(false);
    panel.getStyler().setYAxisMax(1.05 * most);
    return panel;
  }
}
