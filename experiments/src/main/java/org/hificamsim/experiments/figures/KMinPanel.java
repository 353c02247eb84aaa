package org.hificamsim.experiments.figures;

import java.awt.Color;
import org.hificamsim.experiments.plot.Curve;
import org.hificamsim.experiments.plot.Lowess;
import org.hificamsim.experiments.plot.XyPanel;

/**
 * A panel of k_min over time, as chapters 7 and 8 show it: the mean over the runs pale, and LOWESS
 * over it.
 */
public final class KMinPanel {
  /** What the note of a figure says of such panels. */
  public static final String NOTE = "Thick: LOWESS; pale: mean over the runs";

  private static final int RAW_POINTS = 250;

  private final XyPanel panel;

  /** An empty panel whose y axis ends at {@code most}. */
  public KMinPanel(String title, int steps, double most) {
    panel = new XyPanel(title, "time (steps)", "k_min (cameras)").x(0, steps).y(0, most);
  }

  /** Adds the mean beneath; call it for all before the first {@link #smooth}. */
  public KMinPanel raw(double[] means, Color color) {
    panel.faint(Curve.of(means).thinned(RAW_POINTS), color);
    return this;
  }

  /** Adds the smooth line. */
  public KMinPanel smooth(double[] means, Color color) {
    panel.line(Lowess.smooth(Curve.of(means)), color);
    return this;
  }

  /** Adds the smooth line dashed, for a yardstick. */
  public KMinPanel yardstick(double[] means, Color color) {
    panel.dashed(Lowess.smooth(Curve.of(means)), color);
    return this;
  }

  /** The panel for a figure. */
  public XyPanel panel() {
    return panel;
  }
}
