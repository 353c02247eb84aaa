package org.hificamsim.profiling.report;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.DoubleUnaryOperator;
import java.util.stream.IntStream;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.util.MathArrays;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.profiling.fit.Coefficient;
import org.hificamsim.profiling.fit.CurveBand;
import org.hificamsim.profiling.fit.FeatureResult;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.FittedModel;
import org.hificamsim.profiling.fit.LeastSquares;
import org.hificamsim.profiling.fit.Reliability;
import org.hificamsim.profiling.measure.Measurement;
import org.knowm.xchart.XYChart;
import org.knowm.xchart.style.markers.SeriesMarkers;
import smile.stat.distribution.KernelDensity;

/** The figures of chapters 4 to 6, each as a PNG file's bytes. */
final class ReportFigures {
  private static final int FIGURES_A_ROW = 3;
  private static final int MAX_NAMED = 16;
  private static final int CURVE_POINTS = 60;
  private static final int DENSITY_POINTS = 200;

  private final FitResult result;
  private final double[] responses;

  ReportFigures(FitResult result) {
    this.result = result;
    this.responses = Measurement.responses(result.measurements());
  }

  /** A figure of the thesis with these photos, by its number. */
  byte[] figure(String number) {
    return switch (number) {
      case "4.1" -> variables();
      case "4.2" -> transformation();
      case "4.3" -> transformedRegression();
      case "4.4" -> residuals(List.of("lin"));
      case "4.5" -> residuals(List.of("sr"));
      case "4.7" -> residuals(List.of("svr-lin", "svr-rbf"));
      case "6.1" -> combinations();
      case "6.2" -> camSim();
      default -> throw new IllegalArgumentException("there is no figure " + number);
    };
  }

  /** Figure 4.1: the distributions of the variables. */
  byte[] variables() {
    return Charts.png(
        Variable.of(result).stream()
            .map(one -> Charts.histogram(one.name() + " " + one.unit(), one.values()))
            .toList(),
        2);
  }

  /** Figure 4.2: the density of PIP before and after the transformation. */
  byte[] transformation() {
    return Charts.png(
        List.of(density("PIP", result.measuredPip()), density("-log10(PIP)", responses)), 2);
  }

  /** With Gaussian kernels and Scott's bandwidth; of a copy, since Smile sorts what it is given. */
  private static XYChart density(String title, double[] values) {
    double sd = Variable.sd(values);
    double width = Math.max(sd * StrictMath.pow(values.length, -0.2), 1e-9);
    double from = StatUtils.min(values) - 3 * width;
    double step = (StatUtils.max(values) + 3 * width - from) / (DENSITY_POINTS - 1);
    double[] x = IntStream.range(0, DENSITY_POINTS).mapToDouble(i -> from + i * step).toArray();
    XYChart chart = Charts.plot(title, title, "density");
    Charts.line(
        chart, "density", x, at(x, new KernelDensity(values.clone(), width)::p), Charts.BLUE);
    double[] zeros = new double[values.length];
    return Charts.points(chart, "photos", values, zeros, Charts.DOTS, SeriesMarkers.CROSS);
  }

  /** Figure 4.3: multiple linear regression before and after the transformation. */
  byte[] transformedRegression() {
    double[] pip = result.measuredPip();
    XYChart before = Charts.plot("response PIP", "PIP", "predicted PIP");
    Charts.points(before, "photos", pip, linearOnPip(), Charts.DOTS);
    Charts.line(before, "equal", ends(pip), ends(pip), Charts.BLUE);
    double[] log = result.feature("lin").validation().predicted();
    XYChart after = Charts.plot("response -log10(PIP)", "-log10(PIP)", "predicted -log10(PIP)");
    Charts.points(after, "photos", responses, log, Charts.DOTS);
    Charts.line(after, "equal", ends(responses), ends(responses), Charts.BLUE);
    return Charts.png(List.of(before, after), 2);
  }

  /** What multiple linear regression of PIP itself predicts. */
  private double[] linearOnPip() {
    double[][] x = Measurement.predictors(result.measurements());
    double[] fit =
        LeastSquares.fit(x, result.measuredPip(), List.of("q", "d", "z")).stream()
            .mapToDouble(Coefficient::value)
            .toArray();
    return Arrays.stream(x)
        .mapToDouble(row -> fit[0] + fit[1] * row[0] + fit[2] * row[1] + fit[3] * row[2])
        .toArray();
  }

  /** Figures 4.4, 4.5 and 4.7: the residuals of held-out predictions. */
  byte[] residuals(List<String> names) {
    return Charts.png(
        names.stream()
            .map(
                f ->
                    residuals(
                        f,
                        "predicted -log10(PIP)",
                        responses,
                        result.feature(f).validation().predicted()))
            .toList(),
        names.size());
  }

  private static XYChart residuals(
      String title, String label, double[] observed, double[] predicted) {
    XYChart chart = Charts.plot(title, label, "residual");
    Charts.points(
        chart, "photos", predicted, MathArrays.ebeSubtract(observed, predicted), Charts.DOTS);
    return Charts.line(chart, "zero", ends(predicted), new double[2], Charts.BLUE);
  }

  /** Figures 5.3, 5.5 and 5.7: a detector's line on measured PIP, and its residuals. */
  byte[] detector(String detector) {
    double[] pip = result.measuredPip();
    DetectorModel line = result.line(detector, FitResult.GROUND_TRUTH).line();
    return Charts.png(
        List.of(
            fitted(detector, FitResult.GROUND_TRUTH, detector + " on PIP", "PIP"),
            residuals(
                "residuals",
                "predicted confidence",
                result.confidences(detector),
                at(pip, line::confidence))),
        2);
  }

  /** Figure 6.1: each detector on each predicted PIP. */
  byte[] combinations() {
    List<XYChart> charts = new ArrayList<>();
    for (String detector : result.detectors()) {
      for (FeatureResult f : result.features()) {
        charts.add(fitted(detector, f.name(), detector + "-" + f.name(), "predicted PIP"));
      }
    }
    return Charts.png(charts, FIGURES_A_ROW);
  }

  /** Figure 6.2: each detector on CamSim's standard confidence. */
  byte[] camSim() {
    List<XYChart> charts =
        result.detectors().stream()
            .map(detector -> fitted(detector, FitResult.CAMSIM, detector, "CamSim's confidence"))
            .toList();
    return Charts.png(charts, charts.size());
  }

  /** A detector's confidences, and its line on some predictor. */
  private XYChart fitted(String detector, String on, String title, String label) {
    double[] x = result.predictor(on);
    XYChart chart = Charts.plot(title, label, "confidence");
    Charts.points(chart, "photos", x, result.confidences(detector), Charts.DOTS);
    DetectorModel line = result.line(detector, on).line();
    return Charts.line(chart, "line", ends(x), at(ends(x), line::confidence), Charts.BLUE);
  }

  /** A detector's confidence by measured PIP, object by object, with the chosen g and its band. */
  byte[] objects(String detector) {
    XYChart chart = Charts.large(detector + " by object", "PIP (logarithmic)", "confidence");
    chart.getStyler().setXAxisLogarithmic(true);
    Map<String, List<Measurement>> objects = result.byObject();
    chart.getStyler().setLegendVisible(objects.size() <= MAX_NAMED);
    objects.forEach(
        (name, photos) ->
            Charts.points(
                chart,
                name,
                photos.stream().mapToDouble(Measurement::pip).toArray(),
                photos.stream().mapToDouble(m -> m.confidence(detector)).toArray(),
                Color.getHSBColor(
                    chart.getSeriesMap().size() / (float) objects.size(), 0.7f, 0.8f)));
    double[] pip = logarithmic(ends(result.measuredPip()));
    DetectorModel g = result.model(detector, FitResult.GROUND_TRUTH).chosen().g();
    Charts.line(chart, "g", pip, at(pip, g::confidence), Color.BLACK);
    CurveBand band = CurveBand.of(result, detector, pip, 0);
    Charts.line(chart, "95% low", pip, band.low(), Charts.DOTS);
    Charts.line(chart, "95% high", pip, band.high(), Charts.DOTS);
    return Charts.png(List.of(chart), 1);
  }

  /**
   * Reliability: in fifths of the photos, how many are detected over how many are expected to be;
   * before false alarms were taken off, and as the scatter that is taken has it.
   */
  static byte[] reliability(List<FittedModel> models) {
    return Charts.png(models.stream().map(ReportFigures::reliability).toList(), models.size());
  }

  private static XYChart reliability(FittedModel model) {
    XYChart chart = Charts.plot(model.name(), "expected share", "detected share");
    chart.getStyler().setLegendVisible(true);
    chart.getStyler().setMarkerSize(7);
    Charts.line(chart, "equal", new double[] {0, 1}, new double[] {0, 1}, Charts.DOTS);
    fifths(chart, "before", OwnTables.before(model.fit()), Charts.ORANGE);
    fifths(chart, "now", model.fit().drawnFrom().calibration(), Charts.BLUE);
    return chart;
  }

  private static void fifths(XYChart chart, String name, Reliability of, Color colour) {
    double[] x = of.fifths().stream().mapToDouble(Reliability.Part::expected).toArray();
    double[] y = of.fifths().stream().mapToDouble(Reliability.Part::detected).toArray();
    Charts.points(chart, name, x, y, colour);
  }

  private static double[] logarithmic(double[] ends) {
    double ratio = ends[1] / ends[0];
    return IntStream.range(0, CURVE_POINTS)
        .mapToDouble(i -> ends[0] * StrictMath.pow(ratio, i / (CURVE_POINTS - 1.0)))
        .toArray();
  }

  private static double[] at(double[] x, DoubleUnaryOperator curve) {
    return Arrays.stream(x).map(curve).toArray();
  }

  private static double[] ends(double[] values) {
    return new double[] {StatUtils.min(values), StatUtils.max(values)};
  }
}
