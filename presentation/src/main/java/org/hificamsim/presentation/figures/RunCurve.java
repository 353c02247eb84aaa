package org.hificamsim.presentation.figures;

import com.fasterxml.jackson.databind.JsonNode;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Arrays;
import org.hificamsim.core.InputException;
import org.hificamsim.runs.output.ResultFolder;
import org.hificamsim.runs.output.StepRow;

/**
 * What {@code hificamsim run} left in a folder, as far as it is drawn.
 *
 * @param means k_min by step, the mean over the repeats
 */
public record RunCurve(
    String scenario, String detection, String policy, int repeats, double[] means) {
  private static final int MAX_STEPS = 10_000_000;

  /**
   * Reads {@code summary.json} and {@code steps.csv}.
   *
   * @throws InputException when one is missing or is not what a run writes
   */
  public static RunCurve read(Path folder) throws IOException {
    JsonNode summary = new ResultFolder(folder).json(ResultFolder.SUMMARY);
    int repeats = summary.path("repeat").asInt();
    int steps = summary.path("steps").asInt();
    if (repeats < 1 || steps < 1) {
      throw new InputException(
          "%s: steps is %s and repeat is %s, expected what 'hificamsim run' writes"
              .formatted(folder.resolve(ResultFolder.SUMMARY), steps, repeats));
    }
    if (steps > MAX_STEPS) {
      throw new InputException(
          "%s: steps is %s, expected at most %s to draw"
              .formatted(folder.resolve(ResultFolder.SUMMARY), steps, MAX_STEPS));
    }
    long[] sums = new long[steps];
    StepRow.each(folder, row -> sums[row.step(steps)] += row.kMin());
    return new RunCurve(
        summary.path("scenario").asText(),
        summary.path("detection").asText(),
        summary.path("policy").asText(),
        repeats,
        Arrays.stream(sums).mapToDouble(sum -> sum / (double) repeats).toArray());
  }
}
