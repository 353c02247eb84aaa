package org.hificamsim.profiling.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.LineFit;

/**
 * The fidelity ladder: from "certain in view" to support vectors, how well each model tells the
 * measured confidence and how long one evaluation takes.
 */
public final class Ladder {
  /** The models, the plainest first. */
  static final List<String> MODELS =
      List.of("geometric", FitResult.CAMSIM, "lin", "sr", "svr-rbf", "power", "pinhole");

  private Ladder() {}

  /**
   * One step.
   *
   * @param line of the measured confidence on the model's value; {@code geometric}'s value never
   *     varies, so that its line is the mean
   * @param nanoseconds per evaluation; NaN where nobody measured it
   */
  public record Step(String model, LineFit line, double nanoseconds) {}

  /** The ladder of one detector. */
  public static List<Step> of(FitResult result, String detector, Map<String, Double> nanoseconds) {
    List<Step> steps = new ArrayList<>();
    for (String model : MODELS) {
      LineFit line =
          model.equals("geometric")
              ? LineFit.of(new double[result.measurements().size()], result.confidences(detector))
              : result.line(detector, model);
      steps.add(new Step(model, line, nanoseconds.getOrDefault(model, Double.NaN)));
    }
    return steps;
  }
}
