package org.hificamsim.reproduction.network;

import static org.hificamsim.reproduction.network.ExperimentRuns.rounded;

import java.awt.Color;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.energy.EnergyModel;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.core.scenario.spec.CameraSpec;
import org.hificamsim.core.scenario.spec.DutyCycle;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.output.Table;

/**
 * Runs the experiment of {@code docs/energy.md}: the score of cameras and the energy that it takes,
 * if they are awake all the time or take turns in sleeping.
 */
public final class EnergyExperiment {
  /** A radio that is measured, and figures of a camera with motors that are only plausible. */
  private static final EnergyModel ENERGY =
      EnergyModel.parse(
          "cc2420,idle=50mW,sleep=1mW,sense=100mJ,detection=10mJ,pan=10mJ,zoom=100mJ");

  /** The numbers of steps of a period in which cameras are awake. */
  private static final int[] AWAKE = {6, 5, 4, 3, 2};

  private static final int PERIOD = 6;

  /**
   * A way to run the cameras, with its name in the figure.
   *
   * @param thin whether its line is thin, so that it does not cover others
   */
  private record Contender(String name, Settings settings, boolean thin) {
    static Contender policy(String name, String policy) {
      boolean thin = policy.equals("best-fixed");
      return new Contender(name, Settings.NONE.with(Setting.POLICY, policy), thin);
    }

    /** Returns cameras in their widest views that trade targets by one of CamSim's strategies. */
    static Contender strategy(String strategy) {
      return new Contender(
          "CamSim " + strategy,
          Settings.NONE
              .with(Setting.POLICY, "zoom-out")
              .with(Setting.NETWORK, "camsim:strategies=" + strategy),
          strategy.startsWith("P"));
    }
  }

  private static final List<Contender> CONTENDERS =
      List.of(
          Contender.policy("cooperative", "cooperative"),
          Contender.policy("QB-SARSA", "qb-sarsa"),
          Contender.policy("SARSA", "sarsa"),
          Contender.policy("SoftMax", "softmax"),
          Contender.policy("best-fixed", "best-fixed"),
          Contender.strategy("A0"),
          Contender.strategy("P2"));

  /**
   * The energy and score of a contender under a duty cycle.
   *
   * @param awake number of steps of a period in which cameras are awake
   * @param joules energy of a camera in a step, mean over seeds
   * @param share share of the score of the optimum of cameras that are always awake
   */
  private record Outcome(Path file, String contender, int awake, Estimate joules, Estimate share) {}

  private final ExperimentRuns runs;
  private final int steps;
  private final int seeds;
  private final List<Path> files;

  private EnergyExperiment(int steps, int seeds, List<Path> files) {
    this.runs = new ExperimentRuns(Catalogue.load(), steps);
    this.steps = steps;
    this.seeds = seeds;
    this.files = files;
  }

  /**
   * Writes {@code energy.csv} and {@code energy.png}.
   *
   * @param args the folder, steps, seeds, then the scenario files
   */
  public static void main(String[] args) throws IOException {
    EnergyExperiment experiment =
        new EnergyExperiment(
            Integer.parseInt(args[1]),
            Integer.parseInt(args[2]),
            Arrays.stream(args).skip(3).map(Path::of).toList());
    List<Outcome> outcomes = experiment.run();
    try (OutputFolder folder = new OutputFolder(Path.of(args[0]))) {
      table(folder, outcomes);
      try (OutputStream out = folder.stream("energy.png")) {
        FigureFile.png(out, experiment.figure(outcomes));
      }
      folder.commit(List.of());
    }
  }

  private List<Outcome> run() {
    List<Outcome> outcomes = new ArrayList<>();
    for (Path file : files) {
      double[] optima = new double[seeds];
      Arrays.setAll(optima, seed -> runs.run(runs.scenario(file), "optimal", seed).score());
      for (Contender contender : CONTENDERS) {
        for (int awake : AWAKE) {
          outcomes.add(outcome(file, contender, awake, optima));
        }
      }
    }
    return outcomes;
  }

  private Outcome outcome(Path file, Contender contender, int awake, double[] optima) {
    Scenario scenario = scenario(file, awake);
    double[] joules = new double[seeds];
    double[] shares = new double[seeds];
    for (int seed = 0; seed < seeds; seed++) {
      RunResult run = runs.run(scenario, contender.settings, seed);
      joules[seed] = run.value(Metric.ENERGY) / steps / scenario.cameras().size();
      shares[seed] = run.score() / optima[seed];
    }
    return new Outcome(
        file, contender.name, awake, Estimate.mean(joules), Estimate.mean(shares).within(0, 1));
  }

  /** Makes cameras that are neighbours in the file sleep at different times. */
  private Scenario scenario(Path file, int awake) {
    Scenario scenario = runs.scenario(file).with(Scenario.ENERGY, ENERGY);
    List<CameraSpec> cameras = scenario.cameras();
    return scenario.with(
        Scenario.CAMERAS,
        IntStream.range(0, cameras.size())
            .mapToObj(
                camera ->
                    cameras
                        .get(camera)
                        .with(CameraSpec.DUTY, new DutyCycle(awake, PERIOD, camera % PERIOD)))
            .toList());
  }

  private static void table(OutputFolder folder, List<Outcome> outcomes) throws IOException {
    Table.<Outcome>of("energy.csv")
        .texts("scenario", "", outcome -> name(outcome.file))
        .texts("contender", "", Outcome::contender)
        .ints("awake", "steps of " + PERIOD, "", Outcome::awake)
        .doubles("joules", "", "", outcome -> rounded(outcome.joules.mean()))
        .doubles("share", "", "", outcome -> rounded(outcome.share.mean()))
        .doubles("low", "", "", outcome -> rounded(outcome.share.low()))
        .doubles("high", "", "", outcome -> rounded(outcome.share.high()))
        .write(folder, outcomes.stream());
  }

  private static String name(Path file) {
    return file.getFileName().toString().replace(".xml", "");
  }

  private Figure figure(List<Outcome> outcomes) {
    List<LegendEntry> legend =
        IntStream.range(0, CONTENDERS.size())
            .mapToObj(
                i ->
                    new LegendEntry(CONTENDERS.get(i).name, Palette.line(i), LegendEntry.Mark.LINE))
            .toList();
    return new Figure(
        "Score over energy",
        String.format(
            Locale.ROOT,
            "Each point is a duty cycle, from 6 (right) to 2 of 6 steps awake. %d steps, mean of"
                + " %d seeds with 95 %% intervals.",
            steps,
            seeds),
        legend,
        files.stream().map(file -> panel(file, outcomes)).toList(),
        files.size(),
        420,
        320);
  }

  private static XyPanel panel(Path file, List<Outcome> outcomes) {
    List<Outcome> shown = outcomes.stream().filter(outcome -> outcome.file.equals(file)).toList();
    double most = shown.stream().mapToDouble(outcome -> outcome.joules.mean()).max().orElseThrow();
    XyPanel panel =
        new XyPanel(name(file), "joules of a camera in a step", "share of the optimum's score");
    panel.x(0, 1.05 * most);
    panel.y(0, 1);
    for (int i = 0; i < CONTENDERS.size(); i++) {
      Contender contender = CONTENDERS.get(i);
      List<Outcome> own =
          shown.stream().filter(outcome -> outcome.contender.equals(contender.name)).toList();
      draw(panel, own, Palette.line(i), contender.thin);
    }
    return panel;
  }

  private static void draw(XyPanel panel, List<Outcome> outcomes, Color color, boolean thin) {
    Curve curve =
        new Curve(
            outcomes.stream().mapToDouble(outcome -> outcome.joules.mean()).toArray(),
            outcomes.stream().mapToDouble(outcome -> outcome.share.mean()).toArray());
    if (thin) {
      panel.thin(curve, color).diamonds(curve, color);
    } else {
      panel.straight(curve, color).dots(curve, color);
    }
    for (Outcome outcome : outcomes) {
      panel.interval(outcome.joules.mean(), outcome.share.low(), outcome.share.high(), color);
    }
  }
}
