package org.hificamsim.reproduction.ladder;

import java.io.IOException;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.catalogue.Catalogue;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.RunExecutor;
import org.hificamsim.runs.compare.Bootstrap;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.output.CsvTable;
import org.hificamsim.runs.output.JsonOutput;
import org.hificamsim.runs.output.Table;

/** The files of a ladder: two tables, its picture, and what a step costs on this machine. */
public final class LadderFiles {
  /** Between policies that tie; no policy's name or option has it. */
  public static final String OR = " | ";

  private static final String COST = "cost";

  private final OutputFolder folder;
  private final Ladder ladder;
  private final Cases cases;

  private LadderFiles(OutputFolder folder, Ladder ladder, List<CaseResult> results) {
    this.folder = folder;
    this.ladder = ladder;
    this.cases = new Cases(results);
  }

  /** Measures the costs and writes all files. */
  public static LadderResult write(
      OutputFolder folder, Ladder ladder, List<CaseResult> results, Catalogue catalogue)
      throws IOException {
    StepCost cost = new StepCost(new RunExecutor(catalogue), ladder.policies().get(0));
    return new LadderFiles(folder, ladder, results).write(cost.of(ladder.all()));
  }

  private LadderResult write(List<Double> costs) throws IOException {
    LadderResult result = LadderResult.of(ladder, cases, byRung(costs));
    policies();
    rungs(result);
    costs(costs);
    LadderFigures figures = new LadderFigures(result);
    FigureFile.write(folder, "ladder", figures.byScenario());
    FigureFile.write(folder, COST, figures.overview());
    return result;
  }

  /** The mean over the scenarios, by rung. */
  private List<Double> byRung(List<Double> costs) {
    int rungs = ladder.rungs().size();
    return IntStream.range(0, rungs)
        .mapToObj(
            rung ->
                IntStream.range(0, costs.size())
                    .filter(i -> i % rungs == rung)
                    .mapToDouble(costs::get)
                    .average()
                    .orElseThrow())
        .toList();
  }

  private void policies() throws IOException {
    try (CsvTable table = Table.LADDER.create(folder)) {
      for (RungScenario place : ladder.all()) {
        policies(table, place, PolicyScores.of(place.results(cases, ladder.policies())));
      }
    }
  }

  private void policies(CsvTable table, RungScenario place, PolicyScores scores) {
    int[] ranks = scores.ranks();
    for (int policy = 0; policy < ranks.length; policy++) {
      Estimate score = Bootstrap.mean(scores.score()[policy]);
      table.row(
          place.scenario(),
          place.rung().name(),
          ladder.policies().get(policy),
          score.mean(),
          score.low(),
          score.high(),
          ranks[policy]);
    }
  }

  private void rungs(LadderResult result) throws IOException {
    try (CsvTable table = Table.RUNGS.create(folder)) {
      for (RungResult one : result.rungs()) {
        table.row(
            one.scenario(),
            one.rung().name(),
            one.optimum().mean(),
            one.tau().mean(),
            one.tau().low(),
            one.tau().high(),
            String.join(OR, one.chosen()),
            one.regret().mean(),
            one.regret().low(),
            one.regret().high(),
            one.share().mean(),
            one.share().low(),
            one.share().high());
      }
    }
  }

  private void costs(List<Double> costs) throws IOException {
    JsonOutput.write(
        folder,
        COST + ".json",
        json -> {
          json.writeStartObject();
          json.writeStringField("policy", ladder.policies().get(0));
          json.writeNumberField("threads", 1);
          json.writeArrayFieldStart("steps");
          for (int i = 0; i < costs.size(); i++) {
            json.writeStartObject();
            json.writeStringField("scenario", ladder.all().get(i).scenario());
            json.writeStringField("rung", ladder.all().get(i).rung().name());
            json.writeNumberField("nanoseconds", costs.get(i));
            json.writeEndObject();
          }
          json.writeEndArray();
          json.writeEndObject();
        });
  }
}
