package org.hificamsim.profiling.fit;

import java.util.List;
import java.util.Optional;
import org.hificamsim.core.Texts;

/**
 * The recommended model of a detector: the one with the simplest f among those that are as good as
 * the best on unseen objects.
 *
 * @param detector the name of the detector
 * @param model the recommended model; empty if every model is rejected
 * @param best the model with the least error; empty if every model is rejected
 */
public record Recommendation(
    FitResult result, String detector, Optional<FittedModel> model, Optional<FittedModel> best) {
  /** Returns the recommendation for each detector. */
  public static List<Recommendation> all(FitResult result) {
    return result.detectors().stream().map(detector -> of(result, detector)).toList();
  }

  /** Returns the recommendation for a detector. */
  public static Recommendation of(FitResult result, String detector) {
    List<FittedModel> models =
        FittedModel.of(result, detector).stream()
            .filter(model -> !model.onMeasuredPip() && !model.fit().rejected())
            .toList();
    if (models.isEmpty()) {
      return new Recommendation(result, detector, Optional.empty(), Optional.empty());
    }
    List<double[]> errors =
        models.stream().map(candidate -> candidate.fit().chosen().groupErrors()).toList();
    return new Recommendation(
        result,
        detector,
        Optional.of(models.get(OneStandardError.simplest(errors))),
        Optional.of(models.get(OneStandardError.best(errors))));
  }

  /** Returns the R2 of the recommended model on unseen photos; NaN if there is none. */
  public double r2() {
    return model.map(recommended -> recommended.fit().chosen().unseen().r2()).orElse(Double.NaN);
  }

  /** Returns a sentence with the recommendation and its reason. */
  public String sentence() {
    return model
        .map(
            recommended ->
                "Take "
                    + recommended.name()
                    + ": "
                    + explainedShare()
                    + ", "
                    + why(recommended)
                    + ".")
        .orElse(
            Texts.format(
                "No model of %s is one: its confidence does not surely rise with the share of"
                    + " the image.",
                detector));
  }

  private String explainedShare() {
    return Texts.format(
        "on %s that it has not seen it explains %.0f%% of the confidence (R2 %.3f)",
        result.unseen().unit().equals("object") ? "objects" : "photos",
        Math.max(0, 100 * r2()),
        r2());
  }

  private String why(FittedModel recommended) {
    return recommended.equals(best.orElseThrow())
        ? "more than any other"
        : Texts.format(
            "and no other is better by more than a standard error (%s: %.3f); its f is the"
                + " simplest of these",
            best.orElseThrow().name(), best.orElseThrow().fit().chosen().unseen().r2());
  }

  /** Returns sentences on how PIP grows with the focal length, and how far to trust this. */
  public static String lens(FitResult result) {
    List<Coefficient> power = result.feature("power").fit().coefficients();
    Coefficient zoom = power.get(power.size() - 1);
    String yours =
        Double.isNaN(zoom.error())
            ? "Your photos have one focal length, so that nobody knows how PIP grows with it"
            : Texts.format(
                "In your photos PIP grows with the focal length to the power %.2f [%.2f, %.2f]",
                zoom.value(), zoom.low(), zoom.high());
    return yours
        + "; a pinhole camera's power is 2, and so is that of the rendered laboratory. In the six"
        + " real photos of Figure 3.7 it is 1.32, and at 85 mm a pinhole camera predicts a PIP of"
        + " 1.00 where 0.36 was measured: photograph with your own lens before you trust pinhole.";
  }
}
