package org.hificamsim.runs.compare;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.ScoreText;
import org.hificamsim.runs.output.Table;
import org.hificamsim.runs.output.TextTable;

/**
 * The policy that is best under one detection, and its score under the last detection of the list,
 * which is taken to be the most realistic. Scores under two detections cannot be subtracted, since
 * they are those of two different worlds.
 *
 * @param plan a plan with the detection that chose
 * @param chosen the policies with the best score under it, several if they tie
 * @param predicted the mean score of a step of the chosen policies under that detection
 * @param judge the name of the last detection
 * @param achieved the mean score of a step of the chosen policies under the last detection
 */
public record Choice(
    RunPlan plan, List<String> chosen, Estimate predicted, String judge, Estimate achieved) {
  /** A table with a row per scenario and detection, if there are several detections. */
  public static final Table<Choice> FILE =
      Table.<Choice>of("choices.csv")
          .with(ComparisonFiles.CASE.subList(0, 2), Choice::plan)
          .texts(
              "chosen",
              "the policy with the best score under the detection; several, with a bar between,"
                  + " where they tie",
              Choice::policies)
          .estimates(
              "predicted",
              "predicted_",
              "that of `score`, of a step",
              "the chosen policy's score under `detection`",
              Choice::predicted)
          .texts("judge", "the last detection, by which choices are judged", Choice::judge)
          .estimates(
              "achieved",
              "achieved_",
              "that of `score`, of a step",
              "the chosen policy's score under the last detection",
              Choice::achieved);

  /** The choices of all detections in each scenario; none if there is one detection or policy. */
  public static List<Choice> of(List<CaseResult> cases) {
    List<CaseResult> candidates =
        cases.stream().filter(result -> !Yardstick.isYardstick(result.plan().policy())).toList();
    return Cases.byScenario(candidates).values().stream()
        .flatMap(scenario -> of(Cases.byDetection(scenario)).stream())
        .toList();
  }

  private static List<Choice> of(Map<String, List<CaseResult>> detections) {
    List<Choice> choices = new ArrayList<>();
    List<String> names = List.copyOf(detections.keySet());
    String judge = names.get(names.size() - 1);
    RungScores judged = RungScores.of(detections.get(judge));
    if (names.size() > 1 && judged.score().length > 1) {
      detections.values().forEach(cases -> choices.add(of(cases, judge, judged)));
    }
    return choices;
  }

  private static Choice of(List<CaseResult> cases, String judge, RungScores judged) {
    RungScores choosing = RungScores.of(cases);
    int[] best = choosing.best();
    RunPlan plan = cases.get(0).plan();
    return new Choice(
        plan,
        Arrays.stream(best).mapToObj(i -> cases.get(i).plan().policy()).toList(),
        Metric.MEAN_SCORE.mean(plan, choosing.bySeed(best)),
        judge,
        Metric.MEAN_SCORE.mean(plan, judged.bySeed(best)));
  }

  /** Adds the table to a folder's files if there are choices. */
  public static void write(OutputFolder folder, List<CaseResult> cases) throws IOException {
    List<Choice> choices = of(cases);
    if (!choices.isEmpty()) {
      FILE.write(folder, choices.stream());
    }
  }

  /** A table for the terminal with a row for each choice. */
  public static TextTable table(List<Choice> choices) {
    String achieves = "achieves under " + choices.get(0).judge;
    TextTable table =
        new TextTable(3, List.of("scenario", "detection", "chooses", "predicts", achieves));
    for (Choice choice : choices) {
      table.row(
          List.of(
              choice.plan.scenario().name(),
              choice.plan.detection().name(),
              choice.policies(),
              ScoreText.of(choice.plan, choice.predicted),
              ScoreText.of(choice.plan, choice.achieved)));
    }
    return table;
  }

  private String policies() {
    return String.join(" | ", chosen);
  }
}
