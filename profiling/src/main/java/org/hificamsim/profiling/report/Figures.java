package org.hificamsim.profiling.report;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import org.apache.commons.math3.util.MathArrays;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.profiling.fit.CamSimConfidence;
import org.hificamsim.profiling.fit.CurveBand;
import org.hificamsim.profiling.fit.FeatureResult;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.LineFit;
import org.hificamsim.profiling.fit.Observation;
import org.hificamsim.profiling.measure.Measurement;
import org.knowm.xchart.CategoryChart;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.style.markers.SeriesMarkers;

/** The figures of chapters 4 to 6, each as a PNG file's bytes. */
final class Figures {
  private static final int FIGURES_A_ROW = 3;
  private static final int MAX_NAMED = 16;
  private static final int CURVE_POINTS = 60;
  private static final double LEAST_R2 = -1; // one far below 0 would press the others together

  private final FitResult result;
  private final double[] responses;

  Figures(FitResult result) {
    this.result = result;
    this.responses = result.observations().stream().mapToDouble(Observation::response).toArray();
  }

  /** Figure 4.1: the distributions of the variables. */
  byte[] variables() {
    List<CategoryChart> charts = new ArrayList<>();
    Variable.of(result)
        .forEach(v -> charts.add(Charts.histogram(v.name() + " " + v.unit(), v.values())));
    return Charts.png(charts, 2);
  }

  /** Figure 4.2: the density of PIP before and after the transformation. */
  byte[] transformation() {
    return Charts.png(
        List.of(density("PIP", result.measuredPip()), density("-log10(PIP)", responses)), 2);
  }

  /** Figure 4.3: multiple linear regression before and after the transformation. */
  byte[] transformedRegression() {
    double[] pip = result.measuredPip();
    double[] raw = LinearOnPip.predict(result.observations());
    double[] log = result.feature("lin").validation().predicted();
    XYChart before = Charts.plot("response PIP", "PIP", "predicted PIP");
    Charts.points(before, "photos", pip, raw, Charts.DOTS);
    diagonal(before, pip);
    XYChart after = Charts.plot("response -log10(PIP)", "-log10(PIP)", "predicted -log10(PIP)");
    Charts.points(after, "photos", responses, log, Charts.DOTS);
    diagonal(after, responses);
    return Charts.png(List.of(before, after), 2);
  }

  /** Figures 4.4, 4.5 and 4.7: the residuals of held-out predictions. */
  byte[] residuals(List<String> names) {
    List<XYChart> charts = new ArrayList<>();
    for (String f : names) {
      double[] predicted = result.feature(f).validation().predicted();
      XYChart chart = Charts.plot(f, "predicted -log10(PIP)", "residual");
      Charts.points(
          chart, "photos", predicted, MathArrays.ebeSubtract(responses, predicted), Charts.DOTS);
      level(chart, predicted);
      charts.add(chart);
    }
    return Charts.png(charts, charts.size());
  }

  /** Figures 5.3, 5.5 and 5.7: a detector's line on measured PIP, and its residuals. */
  byte[] detector(String detector) {
    double[] pip = result.measuredPip();
    double[] y = result.confidences(detector);
    LineFit fit = result.line(detector, FitResult.GROUND_TRUTH);
    double[] predicted = Arrays.stream(pip).map(fit.line()::confidence).toArray();
    XYChart residuals = Charts.plot("residuals", "predicted confidence", "residual");
    Charts.points(
        residuals, "photos", predicted, MathArrays.ebeSubtract(y, predicted), Charts.DOTS);
    level(residuals, predicted);
    return Charts.png(List.of(fitted(detector + " on PIP", "PIP", pip, y, fit), residuals), 2);
  }

  /** Figure 6.1: each detector on each predicted PIP. */
  byte[] combinations() {
    List<XYChart> charts = new ArrayList<>();
    for (String detector : result.detectors()) {
      for (FeatureResult f : result.features()) {
        charts.add(
            fitted(
                detector + "-" + f.name(),
                "predicted PIP",
                result.predictedPip(f.name()),
                result.confidences(detector),
                result.line(detector, f.name())));
      }
    }
    return Charts.png(charts, FIGURES_A_ROW);
  }

  /** Figure 6.2: each detector on CamSim's standard confidence. */
  byte[] camSim() {
    double[] x = CamSimConfidence.of(result.measurements());
    List<XYChart> charts = new ArrayList<>();
    for (String detector : result.detectors()) {
      LineFit fit = result.line(detector, FitResult.CAMSIM);
      charts.add(fitted(detector, "CamSim's confidence", x, result.confidences(detector), fit));
    }
    return Charts.png(charts, charts.size());
  }

  /** The ladder: what each step costs and buys. */
  static byte[] ladder(List<Ladder.Step> steps, String detector) {
    XYChart chart =
        Charts.large(
            "What each step buys and costs: " + detector,
            "nanoseconds per evaluation of the shipped model",
            "R2, unseen");
    chart.getStyler().setXAxisLogarithmic(true);
    chart.getStyler().setXAxisMin(0.1);
    chart.getStyler().setXAxisMax(100_000.0);
    chart.getStyler().setLegendVisible(true);
    chart.getStyler().setMarkerSize(11);
    double least = 0;
    for (int i = 0; i < steps.size(); i++) {
      Ladder.Step step = steps.get(i);
      if (!(step.unseen().r2() >= LEAST_R2) || !Double.isFinite(step.nanoseconds())) {
        continue;
      }
      double[] x = {step.nanoseconds()};
      double[] y = {step.unseen().r2()};
      least = Math.min(least, y[0]);
      float hue = i / (float) steps.size();
      Charts.points(
          chart,
          step.model(),
          x,
          y,
          Color.getHSBColor(hue, 0.75f, 0.75f),
          i % 2 == 0 ? SeriesMarkers.CIRCLE : SeriesMarkers.DIAMOND);
    }
    chart.getStyler().setYAxisMin(Math.min(-0.05, least - 0.05));
    chart.getStyler().setYAxisMax(1.0);
    return Charts.png(List.of(chart), 1);
  }

  /** A detector's confidence by measured PIP, object by object, with the chosen g and its band. */
  byte[] objects(String detector) {
    XYChart chart = Charts.large(detector + " by object", "PIP (logarithmic)", "confidence");
    chart.getStyler().setXAxisLogarithmic(true);
    List<String> names =
        result.measurements().stream().map(Measurement::object).distinct().toList();
    chart.getStyler().setLegendVisible(names.size() <= MAX_NAMED);
    for (int i = 0; i < names.size(); i++) {
      String name = names.get(i);
      List<Measurement> own =
          result.measurements().stream().filter(m -> m.object().equals(name)).toList();
      Charts.points(
          chart,
          name,
          own.stream().mapToDouble(Measurement::pip).toArray(),
          own.stream().mapToDouble(m -> m.confidence(detector)).toArray(),
          Color.getHSBColor(i / (float) names.size(), 0.7f, 0.8f));
    }
    double[] pip = logarithmic(ends(result.measuredPip()));
    DetectorModel g = result.model(detector, FitResult.GROUND_TRUTH).chosen().g();
    Charts.line(chart, "g", pip, Arrays.stream(pip).map(g::confidence).toArray(), Color.BLACK);
    CurveBand band = CurveBand.of(result, detector, pip, 0);
    Charts.line(chart, "95% low", pip, band.low(), Charts.DOTS);
    Charts.line(chart, "95% high", pip, band.high(), Charts.DOTS);
    return Charts.png(List.of(chart), 1);
  }

  private static double[] logarithmic(double[] ends) {
    double[] x = new double[CURVE_POINTS];
    double ratio = ends[1] / ends[0];
    Arrays.setAll(x, i -> ends[0] * StrictMath.pow(ratio, i / (CURVE_POINTS - 1.0)));
    return x;
  }

  private static XYChart fitted(String title, String label, double[] x, double[] y, LineFit fit) {
    XYChart chart = Charts.plot(title, label, "confidence");
    Charts.points(chart, "photos", x, y, Charts.DOTS);
    double[] ends = ends(x);
    double[] heights = {fit.line().confidence(ends[0]), fit.line().confidence(ends[1])};
    return Charts.line(chart, "line", ends, heights, Charts.BLUE);
  }

  private static XYChart density(String title, double[] values) {
    Density density = Density.of(values);
    XYChart chart = Charts.plot(title, title, "density");
    Charts.line(chart, "density", density.x(), density.y(), Charts.BLUE);
    double[] zeros = new double[values.length];
    return Charts.points(chart, "photos", values, zeros, Charts.DOTS, SeriesMarkers.CROSS);
  }

  private static void diagonal(XYChart chart, double[] values) {
    double[] ends = ends(values);
    Charts.line(chart, "equal", ends, ends, Charts.BLUE);
  }

  private static void level(XYChart chart, double[] values) {
    Charts.line(chart, "zero", ends(values), new double[2], Charts.BLUE);
  }

  private static double[] ends(double[] values) {
    Moments moments = Moments.of(values);
    return new double[] {moments.min(), moments.max()};
  }

  /** One variable of Table 4.1. */
  record Variable(String id, String name, String unit, double[] values) {
    static List<Variable> of(FitResult result) {
      List<Measurement> rows = result.measurements();
      return List.of(
          new Variable(
              "zoom_m",
              "Zoom",
              "(m)",
              rows.stream().mapToDouble(Measurement::focalLength).toArray()),
          new Variable(
              "object_size_m",
              "Object size",
              "(m)",
              rows.stream().mapToDouble(Measurement::size).toArray()),
          new Variable(
              "distance_m",
              "Distance",
              "(m)",
              rows.stream().mapToDouble(Measurement::distance).toArray()),
          new Variable("pip", "PIP", "", result.measuredPip()));
    }
  }
}
