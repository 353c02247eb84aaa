package org.hificamsim.presentation.figures;

import java.awt.Color;
import java.util.Arrays;
import java.util.List;
import java.util.function.ToDoubleFunction;
import java.util.stream.Stream;
import org.hificamsim.core.metrics.Objective;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Lowess;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.FinishedRun;

/**
 * A panel of k_min or another score over time, as chapters 7 and 8 show it: the mean over the runs
 * pale, and LOWESS over it.
 */
public final class KMinPanel extends XyPanel {
  private static final int RAW_POINTS = 250;

  private final int steps;

  /** An empty panel whose y axis ends at {@code most}. */
  public KMinPanel(String title, Objective objective, int steps, double most) {
    super(title, "time (steps)", label(objective));
    this.steps = steps;
    x(0, steps).y(0, most);
  }

  private static String label(Objective objective) {
    if (!objective.hasOwnFigure()) {
      return "k_min (cameras)";
    }
    return objective.isShare() ? "share of " + objective.words() : objective.words();
  }

  /**
   * What the note of a figure says of such panels.
   *
   * @param steps of the longest run
   */
  public static String note(int steps) {
    if (!Lowess.smooths(steps)) {
      return "Mean over the runs";
    }
    String thinned = steps > RAW_POINTS ? ", in " + RAW_POINTS + " groups of steps" : "";
    return "Thick: LOWESS; pale: mean over the runs" + thinned;
  }

  /** The points of a curve that are drawn beneath the smooth one. */
  static Curve drawn(Curve raw) {
    return raw.thinned(RAW_POINTS);
  }

  /** Where a y axis ends that holds all that is drawn of these, and a tenth more. */
  static double ceiling(List<double[]> means) {
    double most =
        means.stream()
            .map(Curve::of)
            .flatMap(curve -> Stream.of(drawn(curve), Lowess.smooth(curve)))
            .flatMapToDouble(curve -> Arrays.stream(curve.y()))
            .max()
            .orElse(1);
    return Math.max(0.2, Math.ceil(most * 1.1 * 5) / 5);
  }

  /** Adds a dashed horizontal line: a published level. */
  public void level(double value, Color color) {
    dashed(new Curve(new double[] {0, steps}, new double[] {value, value}), color);
  }

  /** Adds the mean beneath; call it for all before the first {@link #smooth}. */
  void raw(double[] means, Color color) {
    faint(drawn(Curve.of(means)), color);
  }

  /** Adds the 95% interval of a case's mean over its runs; nothing for a single run. */
  void band(CaseResult one, Color color) {
    if (one.runs().size() > 1) {
      band(bound(one, Estimate::low), bound(one, Estimate::high), color);
    }
  }

  private static Curve bound(CaseResult one, ToDoubleFunction<Estimate> side) {
    int parts = one.levels()[0].length;
    int steps = one.plan().steps();
    double[] x = new double[parts];
    double[] y = new double[parts];
    for (int part = 0; part < parts; part++) {
      int at = part;
      double[] levels = Arrays.stream(one.levels()).mapToDouble(run -> run[at]).toArray();
      x[part] =
          (FinishedRun.start(part, parts, steps) + FinishedRun.start(part + 1, parts, steps) - 1)
              / 2.0;
      y[part] = side.applyAsDouble(Estimate.mean(levels));
    }
    return Lowess.smooth(new Curve(x, y));
  }

  /**
   * Adds a policy's smooth line, dashed for the optimum; where there are too few points to smooth,
   * a straight one.
   */
  void smooth(String policy, double[] means, Color color) {
    Curve curve = Lowess.smooth(Curve.of(means));
    if (PolicyColors.isOptimal(policy)) {
      dashed(curve, color);
    } else if (Lowess.smooths(means.length)) {
      line(curve, color);
    } else {
      straight(curve, color);
    }
  }
}
