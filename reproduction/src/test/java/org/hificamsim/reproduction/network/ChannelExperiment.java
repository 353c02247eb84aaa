package org.hificamsim.reproduction.network;

import static org.hificamsim.reproduction.network.ExperimentRuns.rounded;

import java.awt.Color;
import java.io.IOException;
import java.io.OutputStream;
import java.io.PrintWriter;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.channel.ChannelModel;
import org.hificamsim.core.engine.StepListener;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;
import org.hificamsim.core.scenario.Scenario;
import org.hificamsim.network.CamSimScenario;
import org.hificamsim.network.Network;
import org.hificamsim.network.NetworkRun;
import org.hificamsim.network.NetworkSettings;
import org.hificamsim.network.Strategy;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.runs.DetectionSpec;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.Setting;
import org.hificamsim.runs.Settings;
import org.hificamsim.runs.output.Table;

/**
 * Runs the experiment of {@code docs/channel.md}: the cost of losses, delays and narrow bands for
 * policies whose cameras communicate, for learners that do not, and for CamSim's auctions.
 */
public final class ChannelExperiment {
  private static final String AUCTIONS = "auctions";
  private static final List<String> TALKING = List.of("cooperative", "qb-sarsa");
  private static final List<String> SILENT = List.of("sarsa", "softmax");

  /** A property of the channel that is varied, with a channel for each value. */
  private record Sweep(String title, String key, List<Double> values) {
    ChannelModel channel(double value) {
      String number = key.equals("loss") ? "%s" : "%.0f";
      return ChannelModel.parse(key + "=" + String.format(Locale.ROOT, number, value));
    }

    /** The position of a value on the axis; the axis of bits is logarithmic. */
    double position(double value) {
      return key.equals("bandwidth") ? Math.log(value) / Math.log(2) : value;
    }
  }

  private static final List<Sweep> SWEEPS =
      List.of(
          new Sweep("loss (share of messages)", "loss", List.of(0.0, 0.1, 0.2, 0.5, 1.0)),
          new Sweep("delay (steps)", "delay", List.of(0.0, 1.0, 2.0, 5.0, 10.0)),
          new Sweep(
              "bandwidth (bits a step and camera, log2)",
              "bandwidth",
              List.of(16.0, 32.0, 64.0, 128.0, 256.0)));

  /** The result of a policy over a channel, the mean over scenarios and seeds. */
  private record Outcome(
      String policy, String key, double value, Estimate share, double bits, double dropped) {}

  private final Catalogue catalogue = Catalogue.load();
  private final ExperimentRuns runs;
  private final int steps;
  private final int seeds;
  private final List<Path> files;
  private final Map<String, Double> optima = new HashMap<>();

  private ChannelExperiment(int steps, int seeds, List<Path> files) {
    this.runs = new ExperimentRuns(catalogue, steps);
    this.steps = steps;
    this.seeds = seeds;
    this.files = files;
  }

  /**
   * Writes {@code channel.csv} and {@code channel.png}.
   *
   * @param args the folder, steps, seeds, then the scenario files
   */
  public static void main(String[] args) throws IOException {
    ChannelExperiment experiment =
        new ChannelExperiment(
            Integer.parseInt(args[1]),
            Integer.parseInt(args[2]),
            Arrays.stream(args).skip(3).map(Path::of).toList());
    List<Outcome> outcomes = experiment.run();
    try (OutputFolder folder = new OutputFolder(Path.of(args[0]))) {
      table(folder, outcomes);
      try (OutputStream out = folder.stream("channel.png")) {
        FigureFile.png(out, experiment.figure(outcomes));
      }
      folder.commit(List.of());
    }
  }

  private List<Outcome> run() {
    List<Outcome> outcomes = new ArrayList<>();
    for (String policy : SILENT) {
      Outcome same = outcome(policy, "", 0, ChannelModel.PERFECT);
      SWEEPS.forEach(
          sweep ->
              sweep.values.forEach(
                  value -> outcomes.add(new Outcome(policy, sweep.key, value, same.share, 0, 0))));
    }
    for (Sweep sweep : SWEEPS) {
      for (double value : sweep.values) {
        for (String policy : TALKING) {
          outcomes.add(outcome(policy, sweep.key, value, sweep.channel(value)));
        }
        outcomes.add(auctions(sweep.key, value, sweep.channel(value)));
      }
    }
    return outcomes;
  }

  private Outcome outcome(String policy, String key, double value, ChannelModel channel) {
    double[] shares = new double[seeds];
    double bits = 0;
    double dropped = 0;
    for (Path file : files) {
      Scenario scenario = runs.scenario(file).with(Scenario.CHANNEL, channel);
      for (int seed = 0; seed < seeds; seed++) {
        RunResult run = runs.run(scenario, policy, seed);
        double best = optimum(file, seed);
        shares[seed] += run.score() / best / files.size();
        long sums = (long) seeds * files.size() * steps * scenario.cameras().size();
        bits += run.value(Metric.BITS) / sums;
        dropped += channel.isPerfect() ? 0 : run.value(Metric.MESSAGES_DROPPED) / sums;
      }
    }
    return new Outcome(policy, key, value, Estimate.mean(shares).within(0, 1), bits, dropped);
  }

  /** The exact optimum's score, which no channel changes. */
  private double optimum(Path file, long seed) {
    return optima.computeIfAbsent(
        file + " " + seed, key -> runs.run(runs.scenario(file), "optimal", seed).score());
  }

  /** Counts the targets in sight, and those that are owned by a camera that sees them. */
  private static final class Ownership implements StepListener {
    private final Network network;
    private long seen;
    private long owned;

    Ownership(Network network) {
      this.network = network;
    }

    @Override
    public void stepped(OracleView view, StepCoverage coverage) {
      int[] owners = new int[view.targets()];
      boolean[] watched = new boolean[view.targets()];
      for (int camera = 0; camera < view.cameras(); camera++) {
        for (int target : network.owned(camera)) {
          owners[target]++;
          watched[target] |= network.sightings().sees(camera, target);
        }
      }
      for (int target = 0; target < owners.length; target++) {
        seen += view.coverage(target) > 0 ? 1 : 0;
        owned += view.coverage(target) > 0 && owners[target] == 1 && watched[target] ? 1 : 0;
      }
    }
  }

  /** The auctions of cameras that stay in their home views. */
  private Outcome auctions(String key, double value, ChannelModel channel) {
    double[] shares = new double[seeds];
    double bits = 0;
    double dropped = 0;
    NetworkSettings settings = NetworkSettings.DEFAULT.withStrategies(Strategy.parse("A0"));
    for (Path file : files) {
      PrintWriter nowhere =
          new PrintWriter(OutputStream.nullOutputStream(), false, StandardCharsets.UTF_8);
      Scenario scenario =
          CamSimScenario.read(file, null, false, settings, catalogue, nowhere)
              .with(Scenario.CHANNEL, channel);
      DetectionSpec spec =
          DetectionSpec.parse(
              Settings.NONE.value(Setting.DETECTION, scenario), catalogue::detection);
      for (int seed = 0; seed < seeds; seed++) {
        NetworkRun run =
            new NetworkRun(
                scenario,
                spec.detection(Settings.NONE, scenario),
                catalogue.policies().create("zoom-out"),
                catalogue.movements(),
                settings,
                seed);
        Ownership ownership = new Ownership(run.network());
        run.listen(ownership).run(steps);
        shares[seed] += (double) ownership.owned / Math.max(1, ownership.seen) / files.size();
        long sums = (long) seeds * files.size() * steps * scenario.cameras().size();
        bits += (double) run.traffic().bits() / sums;
        dropped += channel.isPerfect() ? 0 : run.traffic().dropped() / sums;
      }
    }
    return new Outcome(AUCTIONS, key, value, Estimate.mean(shares).within(0, 1), bits, dropped);
  }

  private static void table(OutputFolder folder, List<Outcome> outcomes) throws IOException {
    Table.<Outcome>of("channel.csv")
        .texts("policy", "", Outcome::policy)
        .texts("varied", "", Outcome::key)
        .doubles("value", "", "", Outcome::value)
        .doubles("share", "", "", outcome -> rounded(outcome.share().mean()))
        .doubles("low", "", "", outcome -> rounded(outcome.share().low()))
        .doubles("high", "", "", outcome -> rounded(outcome.share().high()))
        .doubles("bits", "", "", outcome -> rounded(outcome.bits()))
        .doubles("dropped", "", "", outcome -> rounded(outcome.dropped()))
        .write(folder, outcomes.stream());
  }

  private Figure figure(List<Outcome> outcomes) {
    List<String> policies = new ArrayList<>(TALKING);
    policies.addAll(SILENT);
    policies.add(AUCTIONS);
    List<XyPanel> panels = new ArrayList<>();
    for (Sweep sweep : SWEEPS) {
      XyPanel panel = new XyPanel(sweep.title, "", "share of the optimum's score");
      panel.x(
          sweep.position(sweep.values.get(0)),
          sweep.position(sweep.values.get(sweep.values.size() - 1)));
      panel.y(0, 1);
      for (String policy : policies) {
        draw(panel, sweep, outcomes, policy, Palette.line(policies.indexOf(policy)));
      }
      panels.add(panel);
    }
    List<LegendEntry> legend =
        IntStream.range(0, policies.size())
            .mapToObj(
                i ->
                    new LegendEntry(
                        policies.get(i),
                        Palette.line(i),
                        policies.get(i).equals(AUCTIONS)
                            ? LegendEntry.Mark.DASHES
                            : LegendEntry.Mark.LINE))
            .toList();
    return new Figure(
        "What a channel costs",
        String.format(
                Locale.ROOT,
                "%d scenarios, %d steps, mean of %d seeds with 95 %% intervals.",
                files.size(),
                steps,
                seeds)
            + " Of auctions: the share of the targets in sight that have one owner, which sees"
            + " them.",
        legend,
        panels,
        SWEEPS.size(),
        300,
        260);
  }

  private static void draw(
      XyPanel panel, Sweep sweep, List<Outcome> outcomes, String policy, Color color) {
    List<Outcome> own =
        outcomes.stream()
            .filter(outcome -> outcome.policy().equals(policy) && outcome.key().equals(sweep.key))
            .toList();
    double[] x = own.stream().mapToDouble(outcome -> sweep.position(outcome.value())).toArray();
    Curve curve =
        new Curve(x, own.stream().mapToDouble(outcome -> outcome.share().mean()).toArray());
    if (policy.equals(AUCTIONS)) {
      panel.dashed(curve, color);
    } else {
      panel.straight(curve, color);
    }
    for (int i = 0; i < x.length; i++) {
      Estimate share = own.get(i).share();
      panel.interval(x[i], share.low(), share.high(), color);
    }
  }
}
