package org.hificamsim.cli;

import java.io.PrintWriter;
import java.nio.charset.Charset;
import java.nio.charset.StandardCharsets;
import java.nio.file.Path;
import java.util.Arrays;
import java.util.List;
import java.util.Locale;
import java.util.stream.Collectors;
import org.hificamsim.core.Spelling;
import org.hificamsim.core.Texts;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.Reach;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.RunResult;
import org.hificamsim.runs.ScoreText;
import org.hificamsim.runs.SettingSource;

/** Prints the summary of a run. {@code SummaryTables} prints the summary of a comparison. */
final class RunSummary {
  private static final String BLOCKS = "\u2581\u2582\u2583\u2584\u2585\u2586\u2587\u2588";
  private static final String ASCII = "_.:-=+*#";

  private final PrintWriter out;
  private final List<RunResult> results;

  private RunSummary(PrintWriter out, List<RunResult> results) {
    this.out = out;
    this.results = results;
  }

  static void print(
      PrintWriter out, RunPlan plan, List<RunResult> results, double[] overTime, Path folder) {
    RunSummary table = new RunSummary(out, results);
    double[] scores = results.stream().mapToDouble(RunResult::score).toArray();
    String meaning = ScoreText.meaning(plan.objective());
    table.line("score", meaning + ": " + ScoreText.of(plan, scores));
    table.line("scenario", plan.scenario().name());
    table.line(
        "detection",
        plan.detection().name()
            + (plan.detection().certain() ? ", threshold " : ", half of the time at ")
            + plan.detection().threshold());
    table.line("policy", plan.policy());
    table.line(
        "steps",
        plan.steps()
            + (plan.repeats() == 1
                ? ", seed " + plan.seed()
                : " x "
                    + plan.repeats()
                    + " repeats, seeds "
                    + plan.seed()
                    + " to "
                    + plan.seed(plan.repeats() - 1)));
    table.sources(plan);
    table.figures(plan);
    RunResult.zoneShares(results)
        .forEach((zone, met) -> table.line("zone " + zone, Texts.format("%.2f %%", 100 * met)));
    RunResult.unprovenSteps(plan, results).ifPresent(steps -> table.line("not proven", steps));
    RunResult.unprovenExpectation(results).ifPresent(gap -> table.line("not proven", gap));
    table.printReachIfUncovered(plan);
    String figure = plan.objective().hasOwnFigure() ? "score" : plan.objective().stepScore();
    table.line(figure + " over time", bars(overTime, terminal()));
    table.line("files", folder.toString());
    out.flush();
  }

  /** Prints the distance to which targets are detected if the score is 0. */
  private void printReachIfUncovered(RunPlan plan) {
    if (RunResult.mean(plan, results, Metric.SCORE).mean() == 0) {
      line(
          plan.detection().certain() ? "detected up to" : "half of the time",
          Reach.describe(plan.scenario(), plan.detection()));
    }
  }

  /** Prints the sources of the settings that a scenario may have. */
  private void sources(RunPlan plan) {
    String chosen =
        Arrays.stream(SettingSource.values())
            .filter(plan.sources()::containsValue)
            .map(source -> Spelling.of(source) + ": " + labels(plan, source))
            .collect(Collectors.joining("; "));
    line("chosen by", chosen);
  }

  private static String labels(RunPlan plan, SettingSource source) {
    return plan.sources().entrySet().stream()
        .filter(setting -> setting.getValue() == source)
        .map(setting -> setting.getKey().label())
        .collect(Collectors.joining(", "));
  }

  private void figures(RunPlan plan) {
    Metric other = plan.objective().hasOwnFigure() ? Metric.PERFORMANCE : Metric.SCORE;
    for (Metric metric : Metric.values()) {
      boolean isMeasured = results.stream().anyMatch(run -> run.has(metric));
      if (metric.isPrinted() && isMeasured && metric != other) {
        String text = RunResult.mean(plan, results, metric).text(metric.format());
        line(metric.title(), metric.note().isEmpty() ? text : text + "  (" + metric.note() + ")");
      }
    }
  }

  private void line(String label, String text) {
    out.printf(Locale.ROOT, "%-16s %s%n", label, text);
  }

  /**
   * Draws numbers as bars in one line of characters, with the meaning of the lowest and the highest
   * bar: with Unicode's blocks if the character set has them, else with ASCII.
   */
  static String bars(double[] values, Charset charset) {
    String bars = charset.newEncoder().canEncode(BLOCKS) ? BLOCKS : ASCII;
    int last = bars.length() - 1;
    double most = Arrays.stream(values).max().orElse(0);
    StringBuilder line = new StringBuilder();
    for (double value : values) {
      line.append(bars.charAt(most == 0 ? 0 : (int) Math.round(value / most * last)));
    }
    return line + Texts.format("  (%c 0 to %c %.2f)", bars.charAt(0), bars.charAt(last), most);
  }

  /** The character set of the locale; the default of the JVM is UTF-8 on any terminal. */
  private static Charset terminal() {
    String name = System.getProperty("native.encoding", "");
    return !name.isEmpty() && Charset.isSupported(name)
        ? Charset.forName(name)
        : StandardCharsets.US_ASCII;
  }
}
