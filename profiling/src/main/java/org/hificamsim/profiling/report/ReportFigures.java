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
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.profiling.fit.Coefficient;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.FittedModel;
import org.hificamsim.profiling.fit.LeastSquares;
import org.hificamsim.profiling.fit.Reliability;
import org.hificamsim.profiling.measure.Measurement;
import org.knowm.xchart.Histogram;
import smile.stat.distribution.KernelDensity;

/** Draws the figures of chapters 4 to 6, and those of the data set's own numbers. */
final class ReportFigures {
  private static final Color DOTS = Palette.pale(Palette.BLACK, 0.6);
  private static final int WIDTH = 300;
  private static final int HEIGHT = 230;
  private static final int PANELS_PER_ROW = 3;
  private static final int BINS = 30;
  private static final int CURVE_POINTS = 60;
  private static final int DENSITY_POINTS = 200;

  private final FitResult result;
  private final double[] responses;

  ReportFigures(FitResult result) {
    this.result = result;
    this.responses = Measurement.responses(result.measurements());
  }

  /** Draws a figure of the thesis, by its number, with the data set's photos. */
  Figure figure(String number, String title) {
    double[] pip = result.measuredPip();
    return switch (number) {
      case "4.1" ->
          grid(title, Variable.of(result).stream().map(ReportFigures::histogram).toList());
      case "4.2" -> grid(title, List.of(density("PIP", pip), density("-log10(PIP)", responses)));
      case "4.3" ->
          grid(
              title,
              List.of(
                  scatter("PIP", "PIP", "predicted PIP", pip, linearOnPip(), x -> x),
                  scatter(
                      "-log10(PIP)",
                      "-log10(PIP)",
                      "predicted -log10(PIP)",
                      responses,
                      result.feature("lin").validation().predicted(),
                      x -> x)));
      case "4.4" -> grid(title, List.of(residuals("lin")));
      case "4.5" -> grid(title, List.of(residuals("sr")));
      case "4.7" -> grid(title, List.of(residuals("svr-lin"), residuals("svr-rbf")));
      case "6.1" ->
          grid(
              title,
              result.detectors().stream()
                  .flatMap(
                      detector ->
                          result.features().stream()
                              .map(f -> fitted(detector, f.name(), "predicted PIP")))
                  .toList());
      case "6.2" ->
          grid(
              title,
              result.detectors().stream()
                  .map(detector -> fitted(detector, FitResult.CAMSIM, "CamSim's confidence"))
                  .toList());
      default -> throw new IllegalArgumentException("there is no figure " + number);
    };
  }

  private static Figure grid(String title, List<XyPanel> panels) {
    int columns = Math.min(PANELS_PER_ROW, panels.size() == 4 ? 2 : panels.size());
    return new Figure(title, "", List.of(), panels, columns, WIDTH, HEIGHT);
  }

  private static XyPanel panel(String title, String x, String y) {
    return new XyPanel(title, x, y).cloud();
  }

  /** Draws a dot for each photo, and a line over the range of x. */
  private static XyPanel scatter(
      String title,
      String xTitle,
      String yTitle,
      double[] x,
      double[] y,
      DoubleUnaryOperator line) {
    double[] ends = ends(x);
    return panel(title, xTitle, yTitle)
        .dots(new Curve(x, y), DOTS)
        .straight(new Curve(ends, valuesAt(ends, line)), Palette.BLUE);
  }

  private static XyPanel histogram(Variable variable) {
    Histogram bins = new Histogram(Arrays.stream(variable.values()).boxed().toList(), BINS);
    double[] x = new double[2 * BINS];
    double[] y = new double[2 * BINS];
    double width = (bins.getMax() - bins.getMin()) / BINS;
    for (int i = 0; i < x.length; i++) {
      int edge = (i + 1) / 2;
      x[i] = bins.getMin() + edge * width;
      y[i] = bins.getyAxisData().get(i / 2);
    }
    return panel(variable.name(), variable.name() + " " + variable.unit(), "photos")
        .band(new Curve(x, new double[x.length]), new Curve(x, y), Palette.BLUE)
        .thin(new Curve(x, y), Palette.BLUE);
  }

  /**
   * Draws a density with Gaussian kernels and Scott's bandwidth. Smile sorts its argument, hence
   * the copy.
   */
  private static XyPanel density(String title, double[] values) {
    double width = Math.max(Variable.sd(values) * StrictMath.pow(values.length, -0.2), 1e-9);
    double from = StatUtils.min(values) - 3 * width;
    double step = (StatUtils.max(values) + 3 * width - from) / (DENSITY_POINTS - 1);
    double[] x = IntStream.range(0, DENSITY_POINTS).mapToDouble(i -> from + i * step).toArray();
    return panel(title, title, "density")
        .straight(
            new Curve(x, valuesAt(x, new KernelDensity(values.clone(), width)::p)), Palette.BLUE)
        .dots(new Curve(values, new double[values.length]), DOTS);
  }

  /** Returns the predictions of a multiple linear regression of PIP itself. */
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

  /** Draws the residuals of held-out predictions. */
  private XyPanel residuals(String f) {
    double[] predicted = result.feature(f).validation().predicted();
    return residuals(f, "predicted -log10(PIP)", responses, predicted);
  }

  private static XyPanel residuals(
      String title, String label, double[] observed, double[] predicted) {
    double[] errors = MathArrays.ebeSubtract(observed, predicted);
    return scatter(title, label, "residual", predicted, errors, x -> 0);
  }

  /** Draws a detector's line on measured PIP and its residuals (Figures 5.3, 5.5 and 5.7). */
  Figure detector(String detector, String title) {
    DetectorModel line = result.line(detector, FitResult.GROUND_TRUTH).line();
    return grid(
        title,
        List.of(
            fitted(detector, FitResult.GROUND_TRUTH, "PIP"),
            residuals(
                "residuals",
                "predicted confidence",
                result.confidences(detector),
                valuesAt(result.measuredPip(), line::confidence))));
  }

  /** Draws a detector's confidences and its line on a predictor. */
  private XyPanel fitted(String detector, String predictor, String label) {
    DetectorModel line = result.line(detector, predictor).line();
    return scatter(
        detector + " on " + predictor,
        label,
        "confidence",
        result.predictor(predictor),
        result.confidences(detector),
        line::confidence);
  }

  /**
   * Draws a detector's confidence by measured PIP, and g. Objects have colours of their own if
   * there are enough colours.
   */
  Figure objects(String detector) {
    XyPanel panel = panel("", "PIP (logarithmic)", "confidence");
    panel.getStyler().setXAxisLogarithmic(true);
    Map<String, List<Measurement>> objects = result.byObject();
    List<LegendEntry> legend = new ArrayList<>();
    boolean isColored = objects.size() <= Palette.LINES.size();
    objects.forEach(
        (name, photos) -> {
          Color color = isColored ? Palette.LINES.get(legend.size()) : DOTS;
          legend.add(new LegendEntry(name, color, LegendEntry.Mark.DOT));
          panel.dots(
              Curve.of(photos, Measurement::pip, photo -> photo.confidence(detector)), color);
        });
    double[] pip = logarithmic(ends(result.measuredPip()));
    DetectorModel g = result.model(detector, FitResult.GROUND_TRUTH).chosen().g();
    panel.straight(new Curve(pip, valuesAt(pip, g::confidence)), Palette.BLACK);
    return new Figure(
        detector + " by object",
        "Dots: photos. Line: g.",
        isColored ? legend : List.of(),
        List.of(panel),
        1,
        2 * WIDTH,
        2 * HEIGHT);
  }

  /**
   * Draws the detected over the expected share in fifths of the photos, for the former and the
   * chosen scatter.
   */
  static Figure reliability(List<FittedModel> models) {
    return new Figure(
        "Reliability in fifths of the unseen photos",
        "On the line, chances are right.",
        List.of(
            new LegendEntry("before", Palette.ORANGE, LegendEntry.Mark.DOT),
            new LegendEntry("now", Palette.BLUE, LegendEntry.Mark.DOT)),
        models.stream().map(ReportFigures::reliability).toList(),
        models.size(),
        WIDTH,
        HEIGHT);
  }

  private static XyPanel reliability(FittedModel model) {
    double[] diagonal = {0, 1};
    XyPanel panel = panel(model.name(), "expected share", "detected share");
    panel.straight(new Curve(diagonal, diagonal), DOTS);
    fifths(panel, OwnTables.formerReliability(model.fit()), Palette.ORANGE);
    fifths(panel, model.fit().chosenScatter().calibration(), Palette.BLUE);
    return panel;
  }

  private static void fifths(XyPanel panel, Reliability reliability, Color color) {
    panel.dots(
        Curve.of(reliability.fifths(), Reliability.Part::expected, Reliability.Part::detected),
        color);
  }

  private static double[] logarithmic(double[] ends) {
    double ratio = ends[1] / ends[0];
    return IntStream.range(0, CURVE_POINTS)
        .mapToDouble(i -> ends[0] * StrictMath.pow(ratio, i / (CURVE_POINTS - 1.0)))
        .toArray();
  }

  private static double[] valuesAt(double[] x, DoubleUnaryOperator curve) {
    return Arrays.stream(x).map(curve).toArray();
  }

  private static double[] ends(double[] values) {
    return new double[] {StatUtils.min(values), StatUtils.max(values)};
  }
}
