package org.hificamsim.profiling.report;

import java.util.Comparator;
import java.util.List;
import java.util.Locale;
import org.hificamsim.profiling.fit.Counted;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.Recommendation;

/** What the report says of the data set's own numbers: what to take, and how to read the tables. */
final class Advice {
  static final String SHAPES =
      "Confidence on measured PIP. R2, unseen: of photos whose object the fit has not seen. The"
          + " chosen shape is the simplest (in this order) whose error there is within one standard"
          + " error of the least one; profile fit --g takes another.";

  static final String SLOPES =
      "The interval is the wider of two: Student's over photos, and a bootstrap that draws whole"
          + " objects. A detector whose confidence surely rises neither with PIP nor with its"
          + " logarithm is refused: no model of it is written.";

  static final String OBJECTS =
      "How much more confident a detector is of an object than g says, on the mean of its photos:"
          + " texture counts, too. Their standard deviation is the SD between objects above.";

  static final String FEATURES =
      "R2 of -log10(PIP); unseen objects and lenses: of photos whose object or focal length the fit"
          + " has not seen. The pinhole camera fits nothing. The power law keeps the pinhole's"
          + " exponent 2 for what never varies, as with one object or one lens; regressions know"
          + " nothing about it.";

  static final String TIMES =
      "geometric and camsim-standard are what CamSim has: certain in view, and its standard"
          + " confidence. Times are nanoseconds per evaluation of the shipped lab models of the"
          + " same kind, by JMH on one busy machine, about 10 ns of each the benchmark's own; yours"
          + " were not timed. Detections are tabulated before a run, so that a slow model costs"
          + " start-up and not steps.";

  static final String SCATTERS =
      "What --detect chance expects of photos whose object neither g nor the scatter has seen: the"
          + " share whose measured confidence reaches the threshold, over all photos and where a"
          + " fifth of them, in order of the chance, is farthest off. Log loss is the mean of -ln"
          + " of the chance of what happened; the scatter with the lower one is taken. In the first"
          + " row of each model false alarms count as detections, as they did in version 0.1.";

  private Advice() {}

  /** The one sentence that says which model to take. */
  static String headline(FitResult result) {
    return Counted.of(result.measurements().size(), "photo")
        + " of "
        + Counted.of(result.byObject().size(), "object")
        + ". "
        + first(result).sentence();
  }

  /** The detector of which most is explained. */
  static Recommendation first(FitResult result) {
    List<Recommendation> all = Recommendation.all(result);
    return all.stream()
        .filter(one -> Double.isFinite(one.r2()))
        .max(Comparator.comparingDouble(Recommendation::r2))
        .orElse(all.get(0));
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
                + " thresholds.csv, else of --detect chance for one false alarm in twenty:");
    for (String detector : result.detectors()) {
      DetectionAccuracy decisions = DetectionAccuracy.of(result, detector);
      text.append(
          String.format(
              Locale.ROOT,
              " %s %.3f (%.0f%% of the photos),",
              detector,
              decisions.threshold(),
              100 * decisions.detected(result.confidences(detector))));
    }
    return text.substring(0, text.length() - 1) + ".";
  }
}
