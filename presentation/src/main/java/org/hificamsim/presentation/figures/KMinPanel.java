package org.hificamsim.presentation.figures;

import java.awt.Color;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.Map;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.LineLook;
import org.hificamsim.presentation.plot.Lowess;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.RunPlan;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.hificamsim.runs.compare.FinishedRun;
import org.knowm.xchart.XYChart;

/**
 * A panel of k_min or another score over time, as in chapters 7 and 8 of the thesis. It shows the
 * mean over the runs as a pale line, and its LOWESS smoothing on top.
 */
public final class KMinPanel extends XyPanel {
  private static final int RAW_POINTS = 250;
  private static final int WIDTH = 470;

  /** The width of a panel in a row of three, so that pages show its texts as large as others. */
  private static final int NARROW_WIDTH = 340;

  private static final int HEIGHT = 300;

  private final int steps;

  /**
   * Creates an empty panel.
   *
   * @param ceiling the end of the y axis
   */
  public KMinPanel(String title, Objective objective, int steps, double ceiling) {
    super(title, "time (steps)", label(objective));
    this.steps = steps;
    x(0, steps).y(0, ceiling).wholeMarks();
  }

  /** Returns the figure of one scenario. */
  public static Figure figure(String title, List<CaseResult> cases, PolicyColors colors) {
    double ceiling = ceilingOf(cases);
    Map<String, List<CaseResult>> detections = Cases.byDetection(cases);
    List<XYChart> panels = new ArrayList<>();
    detections.forEach(
        (name, group) -> panels.add(of(colors.name(name), group, colors::of, ceiling)));
    return new Figure(
        title,
        note(cases),
        colors.legend(),
        panels,
        Math.min(3, panels.size()),
        panels.size() < 3 ? WIDTH : NARROW_WIDTH,
        HEIGHT);
  }

  /** Returns a panel of cases. */
  public static KMinPanel of(
      String title, List<CaseResult> cases, Function<CaseResult, LineLook> look, double ceiling) {
    RunPlan plan = cases.get(0).plan();
    KMinPanel panel = new KMinPanel(title, plan.objective(), plan.steps(), ceiling);
    PolicyColors.banded(cases).forEach(result -> panel.band(result, look.apply(result).color()));
    cases.forEach(result -> panel.raw(result.meanScore(), look.apply(result).color()));
    cases.forEach(result -> panel.smooth(result.meanScore(), look.apply(result)));
    return panel;
  }

  /** Returns the end of a y axis that has room for all cases; an axis of shares ends at 1. */
  public static double ceilingOf(List<CaseResult> cases) {
    double ceiling = ceiling(cases.stream().map(CaseResult::meanScore).toList());
    return cases.get(0).plan().objective().isShare() ? Math.min(1, ceiling) : ceiling;
  }

  /** Returns the note of a figure that consists of such panels. */
  public static String note(List<CaseResult> cases) {
    int runs = cases.get(0).runs().size();
    RunPlan plan = cases.get(0).plan();
    return note(plan.steps())
        + (runs > 1
            ? " (" + runs + " seeds); bands: 95% intervals of that mean" + bandsOf(cases) + "."
            : ".")
        + (plan.objective().hasOwnFigure() ? " Score: " + plan.objective().words() + "." : "");
  }

  private static String bandsOf(List<CaseResult> cases) {
    List<CaseResult> panel = Cases.byDetection(cases).values().iterator().next();
    return PolicyColors.wordsOfBands(panel.size());
  }

  private static String label(Objective objective) {
    if (!objective.hasOwnFigure()) {
      return "k_min (cameras)";
    }
    return objective.isShare() ? "score (share)" : "score (" + objective.unit() + ")";
  }

  static String note(int steps) {
    if (!Lowess.smooths(steps)) {
      return "Mean over the runs";
    }
    String thinned = steps > RAW_POINTS ? ", in " + RAW_POINTS + " groups of steps" : "";
    return "Thick: LOWESS; pale: mean over the runs" + thinned;
  }

  /** Returns the points of a curve that are drawn below its smooth line. */
  static Curve drawn(Curve raw) {
    return raw.thinned(RAW_POINTS);
  }

  /** Returns the end of a y axis that has room for the curves of these means, in fifths. */
  static double ceiling(List<double[]> means) {
    double greatest =
        means.stream()
            .map(Curve::of)
            .flatMap(curve -> Stream.of(drawn(curve), Lowess.smooth(curve)))
            .flatMapToDouble(curve -> Arrays.stream(curve.y()))
            .max()
            .orElse(1);
    return Math.max(0.2, Math.ceil(5 * greatest) / 5);
  }

  /** Adds a dashed horizontal line for a published value. */
  public void horizontal(double value, Color color) {
    dashed(new Curve(new double[] {0, steps}, new double[] {value, value}), color);
  }

  /** Adds the pale line of a mean. It has to be called for all cases before {@link #smooth}. */
  void raw(double[] means, Color color) {
    faint(drawn(Curve.of(means)), color);
  }

  /** Adds the 95% interval of a case's mean over its runs, if there are several. */
  void band(CaseResult result, Color color) {
    if (result.runs().size() > 1) {
      band(bound(result, Estimate::low), bound(result, Estimate::high), color);
    }
  }

  private static Curve bound(CaseResult result, ToDoubleFunction<Estimate> side) {
    int parts = result.partMeans()[0].length;
    int steps = result.plan().steps();
    double[] x = new double[parts];
    double[] y = new double[parts];
    for (int part = 0; part < parts; part++) {
      x[part] =
          (FinishedRun.start(part, parts, steps) + FinishedRun.start(part + 1, parts, steps) - 1)
              / 2.0;
      y[part] = side.applyAsDouble(result.partMean(part));
    }
    return Lowess.smooth(new Curve(x, y));
  }

  /** Adds the smooth line of a policy; if there are too few points for it, straight lines. */
  void smooth(double[] means, LineLook look) {
    Curve curve = Lowess.smooth(Curve.of(means));
    if (Lowess.smooths(means.length)) {
      line(curve, look);
    } else {
      straight(curve, look);
    }
  }
}
