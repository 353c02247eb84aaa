package org.hificamsim.profiling.fit;

import java.io.IOException;
import java.util.List;
import java.util.Optional;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.hifi.FittedOn;
import org.hificamsim.hifi.FittedOn.Span;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.Provenance;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.hifi.model.ModelFiles;
import org.hificamsim.hifi.model.PublishedModels;
import org.hificamsim.hifi.optics.Optics;
import org.hificamsim.profiling.measure.Measurement;

/**
 * A combination of a detector, an f and a g, which can be written as a model file.
 *
 * @param predictor the predictor of g: the name of f or {@link FitResult#GROUND_TRUTH}
 */
public record FittedModel(FitResult result, String detector, FeatureResult f, String predictor) {
  /** The folder of model files in the folder of a data set. */
  public static final String FOLDER = "models";

  private static final double MIN_SCATTER = 1e-9;

  /** Returns every combination, by detector. */
  public static List<FittedModel> all(FitResult result) {
    return result.detectors().stream().flatMap(detector -> of(result, detector).stream()).toList();
  }

  /** Returns every combination of a detector. */
  public static List<FittedModel> of(FitResult result, String detector) {
    return result.features().stream()
        .flatMap(
            f ->
                Stream.of(f.name(), FitResult.GROUND_TRUTH)
                    .map(predictor -> new FittedModel(result, detector, f, predictor)))
        .toList();
  }

  /**
   * Writes every combination as a model file for detection: {@code <detector>-<f>.json} with the g
   * on f's own predictions, {@code <detector>-<f>-gt.json} with the g on measured PIP. Rejected
   * models are not written.
   *
   * @param prefix the prefix of the models' names, before a colon
   * @return the number of models written
   */
  public static int writeAll(FitResult result, OutputFolder folder, String prefix)
      throws IOException {
    List<FittedModel> accepted =
        all(result).stream().filter(model -> !model.fit().rejected()).toList();
    for (FittedModel model : accepted) {
      folder.write(model.file(), ModelFiles.bytes(model.detection(prefix)));
    }
    return accepted.size();
  }

  /** Returns its file in the folder of a data set. */
  public String file() {
    return FOLDER + "/" + name() + ".json";
  }

  /** Returns {@code <detector>-<f>}, followed by {@code -gt} if g was fitted on measured PIP. */
  public String name() {
    return detector + "-" + f.name() + (onMeasuredPip() ? "-gt" : "");
  }

  /** Returns its fit of g. */
  public DetectorFit fit() {
    return result.model(detector, predictor);
  }

  /** Returns the chosen shape of g. */
  public ShapeFit chosen() {
    return fit().chosen();
  }

  /** Whether g was fitted on measured PIP instead of f's predictions. */
  public boolean onMeasuredPip() {
    return predictor.equals(FitResult.GROUND_TRUTH);
  }

  /** Returns the model; its name starts with the prefix and a colon. */
  public HiFiDetection detection(String prefix) {
    DetectorModel g = chosen().g();
    return new HiFiDetection(
        prefix + ":" + name(),
        f.fit().f(),
        g,
        new Optics(result.camera().sensorWidth(), fittedOn().focalLength().most()),
        result.thresholds().getOrDefault(detector, PublishedModels.published().threshold(g)),
        Optional.of(fit().chosenScatter().residuals())
            .filter(residuals -> residuals.least() > MIN_SCATTER),
        Optional.of(fittedOn()),
        provenance());
  }

  /** Explains why the model is rejected. */
  public String refusal() {
    return Texts.format(
        "%s is no detector: its slope on PIP is %.3g, in [%.3g, %.3g] with 95%%"
            + " confidence; expected one surely above 0",
        name(), fit().slope().slope(), fit().slope().low(), fit().slope().high());
  }

  private FittedOn fittedOn() {
    return new FittedOn(
        span(Measurement::size),
        span(Measurement::distance),
        span(Measurement::focalLength),
        (int) result.measurements().stream().map(Measurement::object).distinct().count(),
        fit().scatter().between(),
        fit().scatter().within());
  }

  private Span span(ToDoubleFunction<Measurement> length) {
    return Span.of(result.measurements().stream().mapToDouble(length).toArray());
  }

  private Provenance provenance() {
    return Provenance.UNKNOWN
        .with("source", "profile fit, " + Texts.counted(result.measurements().size(), "photo"))
        .with("equation", f.fit().equation())
        .with(
            "f",
            Texts.format(
                "R2 %.3f, %d-fold %.3f +- %.3f%s%s, of -log10(PIP)",
                f.scores().r2(),
                f.validation().folds().length,
                f.validation().mean(),
                f.validation().deviation(),
                unseen("objects", f.objects()),
                unseen("lenses", f.lenses())))
        .with(
            "g",
            Texts.format(
                "%s on %s PIP: R2 %.3f, unseen %ss %.3f (RMSE %.4f)",
                chosen().shape(),
                onMeasuredPip() ? "measured" : "predicted",
                chosen().scores().r2(),
                result.unseen().unit(),
                chosen().unseen().r2(),
                chosen().unseen().rmse()));
  }

  private static String unseen(String what, Optional<CrossValidation> validation) {
    return validation.map(scores -> Texts.format(", unseen %s %.3f", what, scores.r2())).orElse("");
  }
}
