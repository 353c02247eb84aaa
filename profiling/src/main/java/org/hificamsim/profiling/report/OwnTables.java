package org.hificamsim.profiling.report;

import static org.hificamsim.profiling.report.CellText.fixed;
import static org.hificamsim.profiling.report.CellText.significant;
import static org.hificamsim.profiling.report.CellText.span;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.stream.Stream;
import org.hificamsim.core.detection.DetectionRule.Chance;
import org.hificamsim.profiling.dataset.TableLayout;
import org.hificamsim.profiling.fit.CrossValidation;
import org.hificamsim.profiling.fit.DetectorFit;
import org.hificamsim.profiling.fit.FeatureResult;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.FittedModel;
import org.hificamsim.profiling.fit.Recommendation;
import org.hificamsim.profiling.fit.Reliability;
import org.hificamsim.profiling.fit.RisingSlope;
import org.hificamsim.profiling.fit.ScatterFit;
import org.hificamsim.profiling.fit.ShapeFit;
import org.hificamsim.profiling.measure.Measurement;
import org.hificamsim.profiling.report.ModelScores.DetectionAccuracy;

/** Adds the tables of the data set's own numbers to the report. */
final class OwnTables {
  static final String FORMER_SCATTER = "constant, false alarms count";

  private final FitResult result;

  OwnTables(FitResult result) {
    this.result = result;
  }

  /** A row of a table: a value of a detector. */
  private record Row<T>(String detector, T value) {}

  /** Adds the table of the recommended models. */
  void recommendations(HtmlPage page) {
    page.table(
        new TableLayout<FittedModel>()
            .with("detector", FittedModel::detector)
            .with("take", FittedModel::name)
            .with("g", model -> model.chosen().shape())
            .with("R2, unseen", model -> fixed(model.chosen().unseen().r2(), 3))
            .with("RMSE, unseen", model -> fixed(model.chosen().unseen().rmse(), 4))
            .with("SD between objects", model -> fixed(model.fit().scatter().between(), 4))
            .with("SD within", model -> fixed(model.fit().scatter().within(), 4))
            .with("detect or not, unseen", model -> fixed(accuracy(model), 3)),
        recommended());
  }

  /** Adds the table of every shape of g on measured PIP. */
  void shapes(HtmlPage page) {
    Function<String, Stream<Row<ShapeFit>>> detectorShapes =
        detector ->
            result.model(detector, FitResult.GROUND_TRUTH).shapes().stream()
                .map(shape -> new Row<>(detector, shape));
    page.table(
        new TableLayout<Row<ShapeFit>>()
            .with("detector", Row::detector)
            .with("g", row -> row.value().shape())
            .with("R2", row -> fixed(row.value().scores().r2(), 3))
            .with("R2, unseen", row -> fixed(row.value().unseen().r2(), 3))
            .with("RMSE, unseen", row -> fixed(row.value().unseen().rmse(), 4))
            .with(
                "chosen",
                row -> row.value().equals(onMeasuredPip(row.detector())) ? "on measured PIP" : "")
            .with("curve", row -> row.value().g().equation()),
        result.detectors().stream().flatMap(detectorShapes).toList());
  }

  private ShapeFit onMeasuredPip(String detector) {
    return result.model(detector, FitResult.GROUND_TRUTH).chosen();
  }

  /** Adds the table of whether each detector's confidence rises with PIP. */
  void slopes(HtmlPage page) {
    page.table(
        new TableLayout<Row<RisingSlope>>()
            .with("detector", Row::detector)
            .with("slope on PIP", row -> significant(row.value().slope()))
            .with("95% interval", row -> span(row.value().low(), row.value().high()))
            .with("rises", row -> rises(row.value())),
        result.detectors().stream()
            .map(
                detector ->
                    new Row<>(detector, result.model(detector, FitResult.GROUND_TRUTH).slope()))
            .toList());
  }

  /** Returns a few words on whether a confidence rises. */
  static String rises(RisingSlope slope) {
    if (!slope.significant()) {
      return "not surely: refused";
    }
    return slope.low() > 0 ? "surely" : "surely with the logarithm";
  }

  /** Adds the table of every f. */
  void features(HtmlPage page) {
    page.table(
        new TableLayout<FeatureResult>()
            .with("f", FeatureResult::name)
            .with("R2", f -> fixed(f.scores().r2(), 3))
            .with("unseen photos", f -> fixed(f.validation().r2(), 3))
            .with("unseen objects", f -> unseen(f.objects()))
            .with("unseen lenses", f -> unseen(f.lenses()))
            .with("RMSE, -log10(PIP)", f -> fixed(f.scores().rmse(), 3))
            .with("equation", f -> f.fit().equation()),
        result.features());
  }

  private static String unseen(Optional<CrossValidation> validation) {
    return fixed(validation.map(CrossValidation::r2).orElse(Double.NaN), 3);
  }

  /** Adds the table of every model g(f), CamSim's models first. */
  void models(HtmlPage page) {
    List<FittedModel> recommended = recommended();
    page.table(
        new TableLayout<ModelScores>()
            .with("model", scores -> scores.detector() + "-" + scores.model())
            .with("g", scores -> scores.fit().shape())
            .with("R2", scores -> fixed(scores.fit().scores().r2(), 3))
            .with("R2, unseen", scores -> fixed(scores.fit().unseen().r2(), 3))
            .with("detect or not, unseen", scores -> fixed(scores.accuracy(), 3))
            .with("verdict", scores -> verdict(scores, recommended)),
        result.detectors().stream()
            .flatMap(detector -> ModelScores.of(result, detector).stream())
            .toList());
  }

  private static String verdict(ModelScores scores, List<FittedModel> recommended) {
    boolean take =
        recommended.stream()
            .anyMatch(
                model ->
                    model.detector().equals(scores.detector())
                        && model.f().name().equals(scores.model()));
    return scores.rejected() ? "refused" : take ? "take" : "";
  }

  /** A scatter of a model, and the reliability of its chances. */
  private record ScatterRow(
      String model, String scatter, Reliability reliability, boolean chosen) {}

  /**
   * Adds the table of the reliability of chances, for each kind of scatter of the recommended
   * models.
   */
  void scatters(HtmlPage page) {
    List<ScatterRow> rows = new ArrayList<>();
    for (FittedModel model : recommended()) {
      DetectorFit fit = model.fit();
      rows.add(new ScatterRow(model.name(), FORMER_SCATTER, formerReliability(fit), false));
      for (ScatterFit scatter : fit.scatters()) {
        boolean chosen = scatter.equals(fit.chosenScatter());
        rows.add(new ScatterRow(model.name(), text(scatter), scatter.calibration(), chosen));
      }
    }
    page.table(
        new TableLayout<ScatterRow>()
            .with("model", ScatterRow::model)
            .with("scatter", ScatterRow::scatter)
            .with("expected, %", row -> fixed(100 * row.reliability.all().expected(), 1))
            .with("measured, %", row -> fixed(100 * row.reliability.all().detected(), 1))
            .with("error, points", row -> fixed(100 * row.reliability.all().error(), 1))
            .with("worst fifth, points", row -> fixed(100 * row.reliability.worstFifth(), 1))
            .with("log loss", row -> fixed(row.reliability.logLoss(), 3))
            .with("chosen", row -> row.chosen ? "taken" : ""),
        rows);
  }

  /** Returns the recommended models; detectors without one are left out. */
  List<FittedModel> recommended() {
    return Recommendation.all(result).stream()
        .flatMap(recommendation -> recommendation.model().stream())
        .toList();
  }

  /**
   * Returns the reliability of the former detection rule chance: a constant scatter, with false
   * alarms counted as detections.
   */
  static Reliability formerReliability(DetectorFit fit) {
    return fit.scatters().get(0).calibration().withFalseAlarms(Chance.DEFAULT_ALPHA);
  }

  private static String text(ScatterFit scatter) {
    return scatter.name()
        + (scatter.residuals().grow()
            ? ": "
                + fixed(scatter.residuals().least(), 4)
                + " + "
                + fixed(scatter.residuals().growth(), 3)
                + " (g - g(0))"
            : ": " + fixed(scatter.residuals().rmse(), 4));
  }

  private double accuracy(FittedModel model) {
    return DetectionAccuracy.of(result, model.detector())
        .accuracy(result.confidences(model.detector()), model.chosen().predicted());
  }

  /** Adds the table of how far the confidences of each object lie above g. */
  void objects(HtmlPage page) {
    TableLayout<List<Measurement>> layout =
        new TableLayout<List<Measurement>>()
            .with("object", photos -> photos.get(0).object())
            .with("size, m", photos -> significant(photos.get(0).size()))
            .with("photos", List::size);
    for (String detector : result.detectors()) {
      layout.with(detector + " above g", photos -> fixed(meanAboveModel(photos, detector), 3));
    }
    page.table(layout, List.copyOf(result.byObject().values()));
  }

  private double meanAboveModel(List<Measurement> photos, String detector) {
    ShapeFit g = onMeasuredPip(detector);
    return photos.stream()
        .mapToDouble(photo -> photo.confidence(detector) - g.g().confidence(photo.pip()))
        .average()
        .orElseThrow();
  }
}
