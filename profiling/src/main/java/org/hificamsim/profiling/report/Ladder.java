package org.hificamsim.profiling.report;

import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.profiling.fit.CamSimConfidence;
import org.hificamsim.profiling.fit.DetectorRegression;
import org.hificamsim.profiling.fit.DetectorShapes;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.Scores;
import org.hificamsim.profiling.fit.ShapeFit;

/**
 * The fidelity ladder: from "certain in view" to support vectors, how well each model tells the
 * confidence of objects that it has not seen and how long one evaluation takes.
 */
public final class Ladder {
  /** The models, the plainest first. */
  static final List<String> MODELS =
      List.of("geometric", FitResult.CAMSIM, "pinhole", "power", "lin", "svr-lin", "sr", "svr-rbf");

  private Ladder() {}

  /**
   * One step.
   *
   * @param unseen how well it tells the confidence of what it has not seen; {@code geometric}'s
   *     value never varies, so that it tells the mean of what it has
   * @param accuracy how often it puts that on the right side of the threshold (balanced)
   * @param nanoseconds per evaluation of the shipped model of this kind; NaN where nobody measured
   */
  public record Step(String model, Scores unseen, double accuracy, double nanoseconds) {}

  /** The ladder of one detector. */
  public static List<Step> of(FitResult result, String detector, Map<String, Double> nanoseconds) {
    Decisions decisions = Decisions.of(result, detector);
    double[] measured = result.confidences(detector);
    List<Step> steps = new ArrayList<>();
    for (String model : MODELS) {
      ShapeFit fit = fit(result, detector, model);
      steps.add(
          new Step(
              model,
              fit.unseen(),
              decisions.accuracy(measured, fit.predicted()),
              nanoseconds.getOrDefault(model, Double.NaN)));
    }
    return steps;
  }

  private static ShapeFit fit(FitResult result, String detector, String model) {
    return switch (model) {
      case "geometric" -> onValues(result, detector, new Mean(), result.measuredPip());
      case FitResult.CAMSIM ->
          onValues(
              result,
              detector,
              DetectorShapes.of("line"),
              CamSimConfidence.of(result.measurements()));
      default -> result.model(detector, model).chosen();
    };
  }

  private static ShapeFit onValues(
      FitResult result, String detector, DetectorRegression g, double[] values) {
    double[][] same =
        IntStream.range(0, result.unseen().count())
            .mapToObj(any -> values)
            .toArray(double[][]::new);
    return ShapeFit.of(g, values, same, result.confidences(detector), result.unseen());
  }

  /** The mean of the confidences, whatever the PIP. */
  private static final class Mean implements DetectorRegression {
    @Override
    public String name() {
      return "mean";
    }

    @Override
    public DetectorModel fit(double[] pip, double[] confidence) {
      return new DetectorLine(0, Arrays.stream(confidence).average().orElseThrow());
    }
  }
}
