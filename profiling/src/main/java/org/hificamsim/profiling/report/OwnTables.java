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

/** The tables of the data set's own numbers. */
final class OwnTables {
  static final String BEFORE = "constant, false alarms count";

  private final FitResult result;

  OwnTables(FitResult result) {
    this.result = result;
  }

  /** Something of a detector's. */
  private record Row<T>(String detector, T of) {}

  /** What to take. */
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

  /** Every shape of g on measured PIP. */
  void shapes(HtmlPage page) {
    Function<String, Stream<Row<ShapeFit>>> ofDetector =
        detector ->
            result.model(detector, FitResult.GROUND_TRUTH).shapes().stream()
                .map(shape -> new Row<>(detector, shape));
    page.table(
        new TableLayout<Row<ShapeFit>>()
            .with("detector", Row::detector)
            .with("g", row -> row.of().shape())
            .with("R2", row -> fixed(row.of().scores().r2(), 3))
            .with("R2, unseen", row -> fixed(row.of().unseen().r2(), 3))
            .with("RMSE, unseen", row -> fixed(row.of().unseen().rmse(), 4))
            .with("", row -> row.of().equals(onMeasuredPip(row.detector())) ? "chosen" : "")
            .with("curve", row -> row.of().g().equation()),
        result.detectors().stream().flatMap(ofDetector).toList());
  }

  private ShapeFit onMeasuredPip(String detector) {
    return result.model(detector, FitResult.GROUND_TRUTH).chosen();
  }

  /** Whether the confidence of each detector rises at all. */
  void slopes(HtmlPage page) {
    page.table(
        new TableLayout<Row<RisingSlope>>()
            .with("detector", Row::detector)
            .with("slope on PIP", row -> significant(row.of().slope()))
            .with("95% interval", row -> span(row.of().low(), row.of().high()))
            .with("rises", row -> rises(row.of())),
        result.detectors().stream()
            .map(d -> new Row<>(d, result.model(d, FitResult.GROUND_TRUTH).slope()))
            .toList());
  }

  /** Whether a confidence rises, in a word or two. */
  static String rises(RisingSlope slope) {
    if (!slope.sure()) {
      return "not surely: refused";
    }
    return slope.low() > 0 ? "surely" : "surely with the logarithm";
  }

  /** Every f. */
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

  /** Every model g(f), and before them what CamSim has. */
  void models(HtmlPage page) {
    page.table(
        new TableLayout<ModelScores>()
            .with("model", one -> one.detector() + "-" + one.model())
            .with("g", one -> one.fit().shape())
            .with("R2", one -> fixed(one.fit().scores().r2(), 3))
            .with("R2, unseen", one -> fixed(one.fit().unseen().r2(), 3))
            .with("detect or not, unseen", one -> fixed(one.accuracy(), 3))
            .with("", one -> one.refused() ? "refused" : ""),
        result.detectors().stream()
            .flatMap(detector -> ModelScores.of(result, detector).stream())
            .toList());
  }

  /** A scatter of a model, and what its chances are worth. */
  private record ScatterRow(String model, String scatter, Reliability of, boolean taken) {}

  /** How good the chances are that follow from each kind of scatter, for the recommended models. */
  void scatters(HtmlPage page) {
    List<ScatterRow> rows = new ArrayList<>();
    for (FittedModel model : recommended()) {
      DetectorFit fit = model.fit();
      rows.add(new ScatterRow(model.name(), BEFORE, before(fit), false));
      for (ScatterFit one : fit.scatters()) {
        boolean taken = one.equals(fit.drawnFrom());
        rows.add(new ScatterRow(model.name(), text(one), one.calibration(), taken));
      }
    }
    page.table(
        new TableLayout<ScatterRow>()
            .with("model", ScatterRow::model)
            .with("scatter", ScatterRow::scatter)
            .with("expected, %", row -> fixed(100 * row.of.all().expected(), 1))
            .with("measured, %", row -> fixed(100 * row.of.all().detected(), 1))
            .with("error, points", row -> fixed(100 * row.of.all().error(), 1))
            .with("worst fifth, points", row -> fixed(100 * row.of.worstFifth(), 1))
            .with("log loss", row -> fixed(row.of.logLoss(), 3))
            .with("", row -> row.taken ? "taken" : ""),
        rows);
  }

  List<FittedModel> recommended() {
    return Recommendation.all(result).stream().flatMap(one -> one.model().stream()).toList();
  }

  /** One number, with false alarms for detections: how {@code --detect chance} was before. */
  static Reliability before(DetectorFit fit) {
    return fit.scatters().get(0).calibration().withFalseAlarms(Chance.DEFAULT_ALPHA);
  }

  private static String text(ScatterFit one) {
    return one.name()
        + (one.residuals().grow()
            ? ": "
                + fixed(one.residuals().least(), 4)
                + " + "
                + fixed(one.residuals().growth(), 3)
                + " (g - g(0))"
            : ": " + fixed(one.residuals().rmse(), 4));
  }

  private double accuracy(FittedModel model) {
    return DetectionAccuracy.of(result, model.detector())
        .accuracy(result.confidences(model.detector()), model.chosen().predicted());
  }

  /** What each object adds to the confidence. */
  void objects(HtmlPage page) {
    TableLayout<List<Measurement>> layout =
        new TableLayout<List<Measurement>>()
            .with("object", photos -> photos.get(0).object())
            .with("size, m", photos -> significant(photos.get(0).size()))
            .with("photos", List::size);
    for (String detector : result.detectors()) {
      layout.with(detector + " above g", photos -> fixed(above(photos, detector), 3));
    }
    page.table(layout, List.copyOf(result.byObject().values()));
  }

  private double above(List<Measurement> photos, String detector) {
    ShapeFit g = onMeasuredPip(detector);
    return photos.stream()
        .mapToDouble(photo -> photo.confidence(detector) - g.g().confidence(photo.pip()))
        .average()
        .orElseThrow();
  }
}
