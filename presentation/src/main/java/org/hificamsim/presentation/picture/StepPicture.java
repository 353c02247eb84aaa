package org.hificamsim.presentation.picture;

import java.awt.Color;
import java.awt.Graphics2D;
import java.awt.geom.Rectangle2D;
import java.math.BigDecimal;
import java.math.MathContext;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;
import org.hificamsim.core.Texts;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.presentation.figures.SpokenNames;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Fonts;
import org.hificamsim.presentation.plot.Legend;
import org.hificamsim.presentation.plot.Paintable;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.presentation.replay.Setup;

/**
 * A picture of one step of a run, which has a heading, the field to scale, and a chart of the score
 * or k_min.
 */
public final class StepPicture implements Paintable {
  static final int WIDTH = 800;
  static final int MARGIN = 12;
  static final int HEADING_HEIGHT = 62;
  static final Color FAINT = new Color(0x6B7785);
  private static final MathContext DIGITS = new MathContext(4);
  private static final int MAX_FIELD_HEIGHT = 900;
  private static final int MIN_FIELD_HEIGHT = 160;
  private static final int CHART_HEIGHT = 110;

  private final RunFrames run;
  private final int index;
  private final Legend legend;

  /**
   * @param index the index of the frame
   */
  public StepPicture(RunFrames run, int index) {
    this.run = run;
    this.index = index;
    this.legend = run.script().legend(run.look(), WIDTH - 2 * MARGIN);
  }

  @Override
  public int width() {
    return WIDTH;
  }

  @Override
  public int height() {
    return (int) area(run).getMaxY() + legend.height() + CHART_HEIGHT + MARGIN;
  }

  /** Returns the area of the field in a picture. */
  static Rectangle2D area(RunFrames run) {
    int width = WIDTH - 2 * MARGIN;
    double height =
        Math.max(MIN_FIELD_HEIGHT, Math.min(MAX_FIELD_HEIGHT, run.script().height(width)));
    return new Rectangle2D.Double(MARGIN, HEADING_HEIGHT, width, Math.round(height));
  }

  @Override
  public void paint(Graphics2D graphics) {
    Rectangle2D area = area(run);
    StepCoverage coverage = run.frame(index).measure();
    Setup setup = run.setup();
    heading(
        graphics,
        "%s, step %s of %s".formatted(setup.scenario(), run.step(index), run.last()),
        run.scores().map(scores -> scores.text(run.score(index))),
        settings(setup, run.recording().seed()),
        Texts.format(
            "k_min %d, %.2f cameras per target; of %d targets %d covered by none, %d by one",
            coverage.kMin(),
            coverage.meanK(),
            coverage.targets(),
            coverage.covered0(),
            coverage.covered1()));
    run.script().paint(graphics, area, run, index, null);
    int top = (int) area.getMaxY();
    legend.paint(graphics, MARGIN, top);
    Graphics2D chart = (Graphics2D) graphics.create();
    chart.translate(MARGIN, top + legend.height());
    scoreChart().paint(chart, (int) area.getWidth(), CHART_HEIGHT);
    chart.dispose();
  }

  /**
   * Returns a chart of the score or k_min over all steps, with a line at the step that is shown.
   */
  private XyPanel scoreChart() {
    double greatest =
        Math.max(1, IntStream.range(0, run.count()).mapToDouble(run::score).max().orElseThrow());
    double last = Math.max(1, run.last());
    double[] shownStep = {run.step(index), run.step(index)};
    return new XyPanel("", "step", run.scores().isPresent() ? "score" : "k_min")
        .x(0, last)
        .y(0, greatest)
        .thin(scoreCorners(), Palette.BLUE)
        .thin(new Curve(shownStep, new double[] {0, greatest}), Palette.BLACK);
  }

  /** Returns the score of all frames as a curve that changes in steps, by its corners. */
  private Curve scoreCorners() {
    List<double[]> corners = new ArrayList<>();
    corners.add(new double[] {run.step(0), run.score(0)});
    for (int i = 1; i < run.count(); i++) {
      if (run.score(i) != run.score(i - 1)) {
        corners.add(new double[] {run.step(i), run.score(i - 1)});
        corners.add(new double[] {run.step(i), run.score(i)});
      }
    }
    corners.add(new double[] {Math.max(1, run.last()), run.score(run.count() - 1)});
    return new Curve(
        corners.stream().mapToDouble(corner -> corner[0]).toArray(),
        corners.stream().mapToDouble(corner -> corner[1]).toArray());
  }

  /** Paints the heading: a title, the score if there is one, the settings, and a result. */
  static void heading(
      Graphics2D graphics, String title, Optional<String> score, String settings, String result) {
    graphics.setColor(Palette.BLACK);
    graphics.setFont(Fonts.TITLE);
    graphics.drawString(title, MARGIN, MARGIN + 12);
    graphics.setFont(Fonts.TEXT);
    score.ifPresent(text -> graphics.drawString(text, MARGIN, MARGIN + 26));
    graphics.setColor(FAINT);
    graphics.drawString(settings, MARGIN, MARGIN + (score.isPresent() ? 39 : 29));
    graphics.drawString(result, MARGIN, MARGIN + (score.isPresent() ? 52 : 44));
  }

  /** Returns the settings of a run in words. */
  static String settings(Setup setup, long seed) {
    return "%s, %s%s%s, seed %s"
        .formatted(
            SpokenNames.of(setup.policy()),
            SpokenNames.of(setup.detection()),
            setup.isByChance() ? ": half of the time at " : " with threshold ",
            BigDecimal.valueOf(setup.threshold())
                .round(DIGITS)
                .stripTrailingZeros()
                .toPlainString(),
            seed);
  }
}
