package org.hificamsim.presentation.figures;

import java.awt.Color;
import java.util.Arrays;
import org.apache.commons.math3.distribution.TDistribution;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Lowess;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.PartMeans;

/**
 * A panel of k_min over time, as chapters 7 and 8 show it: the mean over the runs pale, and LOWESS
 * over it.
 */
public final class KMinPanel {
  private static final int RAW_POINTS = 250;

  private final XyPanel panel;
  private final int steps;

  /** An empty panel whose y axis ends at {@code most}. */
  public KMinPanel(String title, int steps, double most) {
    this.steps = steps;
    panel = new XyPanel(title, "time (steps)", "k_min (cameras)").x(0, steps).y(0, most);
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

  /** Leaves out the axes' titles, for figures of many panels whose note names them. */
  public KMinPanel compact() {
    panel.untitled();
    return this;
  }

  /** Adds a dashed horizontal line: a published level. */
  public KMinPanel level(double value, Color color) {
    panel.dashed(new Curve(new double[] {0, steps}, new double[] {value, value}), color);
    return this;
  }

  /** Adds the mean beneath; call it for all before the first {@link #smooth}. */
  public KMinPanel raw(double[] means, Color color) {
    panel.faint(drawn(Curve.of(means)), color);
    return this;
  }

  /** Adds the 95% interval of a case's mean over its runs; nothing for a single run. */
  public KMinPanel band(CaseResult one, Color color) {
    if (one.runs().size() > 1) {
      panel.band(bound(one, -1), bound(one, 1), color);
    }
    return this;
  }

  private static Curve bound(CaseResult one, int side) {
    int parts = one.levels()[0].length;
    int steps = one.plan().steps();
    double[] x = new double[parts];
    double[] y = new double[parts];
    for (int part = 0; part < parts; part++) {
      int at = part;
      double[] levels = Arrays.stream(one.levels()).mapToDouble(run -> run[at]).toArray();
      x[part] =
          (PartMeans.start(part, parts, steps) + PartMeans.start(part + 1, parts, steps) - 1) / 2.0;
      y[part] = StatUtils.mean(levels) + side * half(levels);
    }
    return Lowess.smooth(new Curve(x, y));
  }

  /** Half of Student's 95% interval. */
  private static double half(double[] values) {
    return new TDistribution(values.length - 1).inverseCumulativeProbability(0.975)
        * Math.sqrt(StatUtils.variance(values) / values.length);
  }

  /** Adds the smooth line; where there are too few points to smooth, a straight one. */
  public KMinPanel smooth(double[] means, Color color) {
    Curve curve = Curve.of(means);
    if (Lowess.smooths(curve.size())) {
      panel.line(Lowess.smooth(curve), color);
    } else {
      panel.straight(curve, color);
    }
    return this;
  }

  /** Adds a policy's smooth line in its colour, dashed for the optimum. */
  void smooth(String policy, double[] means, PolicyColors colors) {
    if (PolicyColors.isOptimal(policy)) {
      panel.dashed(Lowess.smooth(Curve.of(means)), colors.of(policy));
    } else {
      smooth(means, colors.of(policy));
    }
  }

  /** The panel for a figure. */
  public XyPanel panel() {
    return panel;
  }
}
