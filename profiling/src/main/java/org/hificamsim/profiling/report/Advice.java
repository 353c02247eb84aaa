package org.hificamsim.profiling.report;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import org.hificamsim.core.Texts;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.Recommendation;
import org.hificamsim.profiling.report.ModelScores.DetectionAccuracy;

/** What the report says of the data set's own numbers: what to take, and how to read the tables. */
final class Advice {
  private Advice() {}

  /** The one sentence that says which model to take. */
  static String headline(FitResult result) {
    return Texts.format(
        "%s of %s. %s",
        Texts.counted(result.measurements().size(), "photo"),
        Texts.counted(result.byObject().size(), "object"),
        first(result).sentence());
  }

  /** The detector of which most is explained. */
  static Recommendation first(FitResult result) {
    List<Recommendation> all = Recommendation.all(result);
    return all.stream()
        .filter(one -> Double.isFinite(one.r2()))
        .max(Comparator.comparingDouble(Recommendation::r2))
        .orElse(all.get(0));
  }

  /** What to take of the other detectors, and how PIP grows. */
  static List<String> reasons(FitResult result) {
    Recommendation first = first(result);
    List<String> reasons = new ArrayList<>();
    Recommendation.all(result).stream()
        .filter(one -> !one.detector().equals(first.detector()))
        .forEach(one -> reasons.add(one.sentence()));
    reasons.add(Recommendation.lens(result));
    return reasons;
  }

  /** What was left out. */
  static String unseen(FitResult result) {
    return result.unseen().unit().equals("object")
        ? "Unseen: each object's photos are predicted by f and g fitted without that object, since"
            + " photos of one object share its texture. That is what another object has to expect."
        : "All photos show one object. Unseen are folds of its photos, which share its texture:"
            + " what another object has to expect is not known from one.";
  }

  /** On detect or not detect. */
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
