package org.hificamsim.cli;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashSet;
import java.util.List;
import java.util.Locale;
import java.util.Set;
import java.util.concurrent.Callable;
import java.util.function.Function;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.presentation.figures.KMinPanel;
import org.hificamsim.presentation.figures.OverTime;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.runs.output.StepRow;
import picocli.CommandLine.Command;
import picocli.CommandLine.Mixin;
import picocli.CommandLine.Option;
import picocli.CommandLine.Parameters;

/** {@code hificamsim plot}: the score over time of a few runs, in one picture. */
@Command(
    name = "plot",
    description =
        "Plots the score over time for several runs (k_min if their scores differ in kind).")
final class PlotCommand implements Callable<Integer> {
  @Parameters(arity = "1..*", paramLabel = "DIR", description = "Folders that 'run' has written.")
  private List<Path> folders;

  @Option(names = "--out", paramLabel = "FILE.png|.svg|.pdf")
  private Path out;

  @Mixin private Destination destination;

  @Override
  public Integer call() throws IOException {
    String name = out.toString().toLowerCase(Locale.ROOT);
    String format = name.substring(name.lastIndexOf('.') + 1);
    if (!FigureFile.FORMATS.contains(format)) {
      throw InputException.of(
          "--out is '%s', expected a name that ends in .png, .svg or .pdf", out);
    }
    OutputFile file = destination.inFolder("--out", out);
    Objective objective = objective();
    List<RunCurve> runs = new ArrayList<>();
    for (Path folder : folders) {
      runs.add(RunCurve.read(folder, objective));
    }
    Figure figure = figure(runs, objective);
    file.write(stream -> FigureFile.write(stream, format, figure));
    return 0;
  }

  /** That of all runs: one axis has one unit. */
  private Objective objective() throws IOException {
    Set<String> names = new HashSet<>();
    for (Path folder : folders) {
      OutputFolder.settle(folder);
      JsonNode summary = new ResultFolder(folder).json(ResultFolder.SUMMARY);
      names.add(summary.has("score_words") ? summary.path("objective").asText() : ""); // since 0.2
    }
    return names.size() == 1 && !names.contains("")
        ? Objective.parse(names.iterator().next())
        : Objective.kMin();
  }

  private Figure figure(List<RunCurve> runs, Objective objective) {
    List<Function<RunCurve, String>> parts =
        List.of(RunCurve::scenario, RunCurve::detection, RunCurve::policy);
    List<Function<RunCurve, String>> differ =
        parts.stream().filter(part -> runs.stream().map(part).distinct().count() > 1).toList();
    List<Function<RunCurve, String>> same =
        parts.stream().filter(part -> !differ.contains(part)).toList();
    List<OverTime.Line> lines = new ArrayList<>();
    for (int i = 0; i < runs.size(); i++) {
      String label = differ.isEmpty() ? folders.get(i).toString() : join(runs.get(i), differ, " ");
      lines.add(new OverTime.Line(label, runs.get(i).means()));
    }
    int steps = runs.stream().mapToInt(run -> run.means().length).max().orElseThrow();
    return OverTime.figure(
        objective.hasOwnFigure() ? "Score over time" : "Coverage redundancy over time",
        objective,
        join(runs.get(0), same, ", ") + ". " + KMinPanel.note(steps) + repeats(runs) + ".",
        lines);
  }

  private static String repeats(List<RunCurve> runs) {
    List<Integer> repeats = runs.stream().map(RunCurve::repeats).distinct().toList();
    return repeats.size() == 1 && repeats.get(0) > 1 ? " (" + repeats.get(0) + " seeds)" : "";
  }

  private static String join(
      RunCurve run, List<Function<RunCurve, String>> parts, String separator) {
    return String.join(separator, parts.stream().map(part -> part.apply(run)).toList());
  }

  /**
   * What {@code hificamsim run} left in a folder, as far as it is drawn.
   *
   * @param means the score or k_min by step, the mean over the repeats
   */
  private record RunCurve(
      String scenario, String detection, String policy, int repeats, double[] means) {
    private static final int MAX_STEPS = 10_000_000;

    /**
     * Reads {@code summary.json} and {@code steps.csv}.
     *
     * @throws InputException when one is missing or is not what a run writes
     */
    static RunCurve read(Path folder, Objective objective) throws IOException {
      JsonNode summary = new ResultFolder(folder).json(ResultFolder.SUMMARY);
      int repeats = summary.path("repeat").asInt();
      int steps = summary.path("steps").asInt();
      if (repeats < 1 || steps < 1) {
        throw InputException.of(
            "%s: steps is %s and repeat is %s, expected what 'hificamsim run' writes",
            folder.resolve(ResultFolder.SUMMARY), steps, repeats);
      }
      if (steps > MAX_STEPS) {
        throw InputException.of(
            "%s: steps is %s, expected at most %s to draw",
            folder.resolve(ResultFolder.SUMMARY), steps, MAX_STEPS);
      }
      boolean scored = objective.hasOwnFigure();
      double[] sums = new double[steps];
      StepRow.each(folder, row -> sums[row.step(steps)] += scored ? row.score() : row.kMin());
      return new RunCurve(
          summary.path("scenario").asText(),
          summary.path("detection").asText(),
          summary.path("policy").asText(),
          repeats,
          Arrays.stream(sums).map(sum -> sum / repeats).toArray());
    }
  }
}
