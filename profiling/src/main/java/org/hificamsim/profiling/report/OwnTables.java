package org.hificamsim.profiling.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import org.hificamsim.profiling.fit.CrossValidation;
import org.hificamsim.profiling.fit.DetectorFit;
import org.hificamsim.profiling.fit.DetectorShapes;
import org.hificamsim.profiling.fit.FeatureResult;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.FittedModel;
import org.hificamsim.profiling.fit.Recommendation;
import org.hificamsim.profiling.fit.RisingSlope;
import org.hificamsim.profiling.fit.ShapeFit;
import org.hificamsim.profiling.measure.Measurement;

/** The tables of the data set's own numbers. */
final class OwnTables {
  private final FitResult result;

  OwnTables(FitResult result) {
    this.result = result;
  }

  /** What to take. */
  void recommendations(HtmlPage page) {
    List<List<String>> rows = new ArrayList<>();
    for (Recommendation one : Recommendation.all(result)) {
      Decisions decisions = Decisions.of(result, one.detector());
      one.model()
          .ifPresent(
              model ->
                  rows.add(
                      List.of(
                          one.detector(),
                          model.name(),
                          model.fit().chosen().shape(),
                          Cells.fixed(one.r2(), 3),
                          Cells.fixed(model.fit().chosen().unseen().rmse(), 4),
                          Cells.fixed(model.fit().scatter().between(), 4),
                          Cells.fixed(model.fit().scatter().within(), 4),
                          Cells.fixed(accuracy(decisions, model), 3))));
    }
    page.table(
        List.of(
            "detector",
            "take",
            "g",
            "R2, unseen",
            "RMSE, unseen",
            "SD between objects",
            "SD within",
            "detect or not, unseen"),
        rows);
  }

  /** Every shape of g on measured PIP. */
  void shapes(HtmlPage page) {
    List<String> columns =
        new ArrayList<>(List.of("detector", "g", "R2", "R2, unseen", "RMSE, unseen", "", "curve"));
    List<List<String>> rows = new ArrayList<>();
    for (String detector : result.detectors()) {
      DetectorFit fit = result.model(detector, FitResult.GROUND_TRUTH);
      for (String name : DetectorShapes.names()) {
        ShapeFit shape = fit.shape(name);
        rows.add(
            List.of(
                detector,
                name,
                Cells.fixed(shape.scores().r2(), 3),
                Cells.fixed(shape.unseen().r2(), 3),
                Cells.fixed(shape.unseen().rmse(), 4),
                shape.equals(fit.chosen()) ? "chosen" : "",
                Curves.equation(shape.g())));
      }
    }
    page.table(columns, rows);
  }

  /** Whether the confidence of each detector rises at all. */
  void slopes(HtmlPage page) {
    page.table(
        List.of("detector", "slope on PIP", "95% interval", "rises"),
        result.detectors().stream()
            .map(
                detector -> {
                  var slope = result.model(detector, FitResult.GROUND_TRUTH).slope();
                  return List.of(
                      detector,
                      Cells.significant(slope.slope()),
                      Cells.span(slope.low(), slope.high()),
                      rises(slope));
                })
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
    List<List<String>> rows = new ArrayList<>();
    for (FeatureResult f : result.features()) {
      rows.add(
          List.of(
              f.name(),
              Cells.fixed(f.scores().r2(), 3),
              Cells.fixed(f.validation().r2(), 3),
              unseen(f.objects()),
              unseen(f.lenses()),
              Cells.fixed(f.scores().rmse(), 3),
              f.fit().equation()));
    }
    page.table(
        List.of(
            "f",
            "R2",
            "unseen photos",
            "unseen objects",
            "unseen lenses",
            "RMSE, -log10(PIP)",
            "equation"),
        rows);
  }

  /** Every model g(f). */
  void models(HtmlPage page) {
    List<List<String>> rows = new ArrayList<>();
    for (FittedModel model : FittedModel.all(result)) {
      if (!model.onMeasuredPip()) {
        rows.add(model(model));
      }
    }
    page.table(
        List.of("model", "g", "R2", "R2, unseen", "line's R2, unseen", "detect or not, unseen", ""),
        rows);
  }

  private List<String> model(FittedModel model) {
    ShapeFit chosen = model.fit().chosen();
    return List.of(
        model.name(),
        chosen.shape(),
        Cells.fixed(chosen.scores().r2(), 3),
        Cells.fixed(chosen.unseen().r2(), 3),
        Cells.fixed(model.fit().shape("line").unseen().r2(), 3),
        Cells.fixed(accuracy(Decisions.of(result, model.detector()), model), 3),
        model.fit().refused() ? "refused" : "");
  }

  /** What each object adds to the confidence. */
  void objects(HtmlPage page) {
    List<String> columns = new ArrayList<>(List.of("object", "size, m", "photos"));
    result.detectors().forEach(detector -> columns.add(detector + " above g"));
    List<String> names =
        result.measurements().stream().map(Measurement::object).distinct().toList();
    page.table(columns, names.stream().map(this::object).toList());
  }

  private List<String> object(String name) {
    List<Measurement> own =
        result.measurements().stream().filter(m -> m.object().equals(name)).toList();
    List<String> row =
        new ArrayList<>(
            List.of(name, Cells.significant(own.get(0).size()), String.valueOf(own.size())));
    for (String detector : result.detectors()) {
      ShapeFit g = result.model(detector, FitResult.GROUND_TRUTH).chosen();
      double above =
          own.stream()
              .mapToDouble(m -> m.confidence(detector) - g.g().confidence(m.pip()))
              .average()
              .orElseThrow();
      row.add(Cells.fixed(above, 3));
    }
    return row;
  }

  /** The ladder, with every detector. */
  void ladder(HtmlPage page, Map<String, List<Ladder.Step>> ladders) {
    List<String> columns = new ArrayList<>(List.of("model"));
    ladders.keySet().forEach(d -> columns.addAll(List.of(d + " R2, unseen", d + " detect or not")));
    columns.add("ns, shipped model");
    List<List<String>> rows = new ArrayList<>();
    for (int i = 0; i < Ladder.MODELS.size(); i++) {
      List<String> row = new ArrayList<>(List.of(Ladder.MODELS.get(i)));
      double nanoseconds = Double.NaN;
      for (List<Ladder.Step> steps : ladders.values()) {
        row.add(Cells.fixed(steps.get(i).unseen().r2(), 3));
        row.add(Cells.fixed(steps.get(i).accuracy(), 3));
        nanoseconds = steps.get(i).nanoseconds();
      }
      row.add(Cells.significant(nanoseconds));
      rows.add(row);
    }
    page.table(columns, rows);
  }

  private double accuracy(Decisions decisions, FittedModel model) {
    return decisions.accuracy(
        result.confidences(model.detector()), model.fit().chosen().predicted());
  }

  private static String unseen(Optional<CrossValidation> validation) {
    return Cells.fixed(validation.map(CrossValidation::r2).orElse(Double.NaN), 3);
  }
}
