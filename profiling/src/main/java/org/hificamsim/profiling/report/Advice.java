package org.hificamsim.profiling.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.hificamsim.core.Texts;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.Recommendation;
import org.hificamsim.profiling.report.ModelScores.DetectionAccuracy;

/** Composes the report's sentences: recommendations, and explanations of its tables. */
final class Advice {
  private Advice() {}

  /** Returns the sentence that recommends a model. */
  static String headline(FitResult result) {
    return Texts.format(
        "%s of %s. %s",
        Texts.counted(result.measurements().size(), "photo"),
        Texts.counted(result.byObject().size(), "object"),
        best(result).sentence());
  }

  /** Returns the recommendation that explains the largest share of the confidence. */
  static Recommendation best(FitResult result) {
    List<Recommendation> recommendations = Recommendation.all(result);
    return recommendations.stream()
        .filter(recommendation -> Double.isFinite(recommendation.r2()))
        .max(Comparator.comparingDouble(Recommendation::r2))
        .orElse(recommendations.get(0));
  }

  /**
   * Returns the recommendations for the other detectors, and how PIP grows with the focal length.
   */
  static List<String> reasons(FitResult result) {
    Recommendation best = best(result);
    List<String> reasons = new ArrayList<>();
    Recommendation.all(result).stream()
        .filter(recommendation -> !recommendation.detector().equals(best.detector()))
        .forEach(recommendation -> reasons.add(recommendation.sentence()));
    reasons.add(Recommendation.lens(result));
    return reasons;
  }

  /** Describes the groups that the cross-validation leaves out. */
  static String unseen(FitResult result) {
    return result.unseen().unit().equals("object")
        ? "Unseen: each object's photos are predicted by f and g fitted without that object, since"
            + " photos of one object share its texture. That is what another object has to expect."
        : "All photos show one object. Unseen are folds of its photos, which share its texture:"
            + " what another object has to expect is not known from one.";
  }

  /** Describes the thresholds that decide between detected and not detected. */
  static String decisions(FitResult result) {
    StringBuilder text =
        new StringBuilder(
            "Detect or not, unseen: how often model and measurement are on the same side of the"
                + " threshold (balanced accuracy: one half is a guess). The threshold is that of"
                + " thresholds.csv, else of the rule chance for one false alarm in twenty:");
    for (String detector : result.detectors()) {
      DetectionAccuracy decisions = DetectionAccuracy.of(result, detector);
      text.append(
          Texts.format(
              " %s %.3f (%.0f%% of the photos),",
              detector,
              decisions.threshold(),
              100 * decisions.detected(result.confidences(detector))));
    }
    return text.substring(0, text.length() - 1) + ".";
  }
}
