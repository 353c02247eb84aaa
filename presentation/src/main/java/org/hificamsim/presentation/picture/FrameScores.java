package org.hificamsim.presentation.picture;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.HashMap;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.core.Texts;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.presentation.replay.RecordedRun;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.runs.output.StepRow;

/**
 * The scores of a recorded run whose objective is not k_min.
 *
 * @param byStep for each step, its score
 * @param mean the mean score of a step over all repeats
 */
public record FrameScores(Objective objective, Map<Long, Double> byStep, double mean) {
  /** Reads the scores from the folder of a run; returns nothing if the objective is k_min. */
  public static Optional<FrameScores> read(Path folder, RecordedRun run) throws IOException {
    JsonNode summary = new ResultFolder(folder).json(ResultFolder.SUMMARY);
    Objective objective = Objective.parse(summary.path("objective").asText("kmin"));
    if (!objective.hasOwnFigure()) {
      return Optional.empty();
    }
    int steps = summary.path("steps").asInt();
    Map<Long, Double> byStep = new HashMap<>();
    StepRow.forEachRow(
        folder,
        row -> {
          if (row.run() == run.run()) {
            byStep.put(row.step(), row.score());
          }
        });
    return Optional.of(
        new FrameScores(objective, byStep, summary.path("score").asDouble() / steps));
  }

  /** Returns a score in words, such as {@code targets covered by at least one camera: 61.0 %}. */
  String text(double score) {
    String number = objective.isShare() ? "%.1f %%" : "%.2f";
    double shown = objective.isShare() ? 100 * score : score;
    return objective.words() + ": " + Texts.format(number, shown);
  }
}
