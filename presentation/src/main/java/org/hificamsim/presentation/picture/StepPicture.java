package org.hificamsim.presentation.picture;

import java.awt.BasicStroke;
import java.awt.Graphics2D;
import java.awt.Shape;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Rectangle2D;
import java.util.Locale;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.scenario.Field;
import org.hificamsim.presentation.plot.Fonts;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.Picture;
import org.hificamsim.presentation.replay.Setup;

/** One step of a run: what it is, the field to scale, and k_min over all steps below. */
public final class StepPicture implements Picture {
  static final int WIDTH = 800;
  private static final int MAX_FIELD = 900;
  private static final int MIN_FIELD = 160;
  static final int MARGIN = 12;
  private static final int HEADING = 62;
  private static final int LEGEND = 24;
  private static final int GUTTER = 36;
  private static final int BETWEEN = 20;
  private static final int STRIP = 66;

  private final RunFrames run;
  private final int index;
  private final SiteLegend site;

  /**
   * @param index the frame to be shown
   */
  public StepPicture(RunFrames run, int index) {
    this.run = run;
    this.index = index;
    this.site = new SiteLegend(run.setup(), run.look());
  }

  @Override
  public int width() {
    return WIDTH;
  }

  @Override
  public int height() {
    return HEADING + fieldHeight(run.setup().field()) + legendHeight() + BETWEEN + STRIP + MARGIN;
  }

  private int legendHeight() {
    return LEGEND * (1 + site.lines());
  }

  private static int fieldHeight(Field field) {
    double asWide = fieldWidth() * FieldMap.height(field) / FieldMap.width(field);
    return (int) Math.max(MIN_FIELD, Math.min(MAX_FIELD, Math.round(asWide)));
  }

  private static int fieldWidth() {
    return WIDTH - 2 * MARGIN;
  }

  private static Rectangle2D area(Field field) {
    return area(field, HEADING);
  }

  /** Where a field is in a picture, below a heading of this height, points. */
  static Rectangle2D area(Field field, int heading) {
    return new Rectangle2D.Double(MARGIN, heading, fieldWidth(), fieldHeight(field));
  }

  /** Where metres are in the picture. */
  static FieldMap map(Field field) {
    return FieldMap.fit(field, area(field));
  }

  @Override
  public void paint(Graphics2D graphics) {
    heading(graphics);
    Rectangle2D field = area(run.setup().field());
    Shape before = graphics.getClip();
    graphics.clip(field);
    new FieldPainter(graphics, run, index, field).paint();
    graphics.setClip(before);
    legend(graphics, (int) field.getMaxY() + LEGEND / 2);
    site.paint(graphics, MARGIN, (int) field.getMaxY() + LEGEND + LEGEND / 2, LEGEND);
    Rectangle2D strip =
        new Rectangle2D.Double(
            MARGIN + GUTTER,
            field.getMaxY() + legendHeight() + BETWEEN,
            (double) fieldWidth() - GUTTER,
            STRIP);
    new KMinStrip(graphics, run, strip).paint(index);
  }

  private void heading(Graphics2D graphics) {
    Setup setup = run.setup();
    StepCoverage coverage = run.frame(index).measure();
    graphics.setColor(Palette.BLACK);
    graphics.setFont(Fonts.TITLE);
    graphics.drawString(
        "%s, step %s of %s".formatted(setup.scenario(), run.step(index), run.last()),
        MARGIN,
        MARGIN + 12);
    graphics.setColor(FieldPainter.FAINT);
    graphics.setFont(Fonts.TEXT);
    graphics.drawString(settings(setup, run.recording().seed()), MARGIN, MARGIN + 29);
    graphics.drawString(
        String.format(
            Locale.ROOT,
            "k_min %d, %.2f cameras per target; of %d targets %d covered by none, %d by one",
            coverage.kMin(),
            coverage.meanK(),
            coverage.targets(),
            coverage.covered0(),
            coverage.covered1()),
        MARGIN,
        MARGIN + 44);
  }

  /** What a run was run under, in words. */
  static String settings(Setup setup, long seed) {
    return "%s, %s%s%s, seed %s"
        .formatted(
            setup.policy(),
            setup.detection(),
            setup.byChance() ? ": half of the time at " : " with threshold ",
            setup.threshold(),
            seed);
  }

  private static void legend(Graphics2D graphics, int middle) {
    graphics.setFont(Fonts.TEXT);
    int x = word(graphics, "covered by", MARGIN, middle);
    for (CoverClass cover : CoverClass.values()) {
      graphics.setColor(cover.color());
      graphics.fill(cover.at(x + 6.0, middle, 5.5));
      x = word(graphics, cover.label(), x + 16, middle);
    }
    graphics.setColor(SightPainter.RANGE);
    graphics.setStroke(
        new BasicStroke(
            1, BasicStroke.CAP_BUTT, BasicStroke.JOIN_ROUND, 10, new float[] {3, 2}, 0));
    graphics.draw(new Ellipse2D.Double(x, middle - 6.0, 12, 12));
    x = word(graphics, "field of view", x + 16, middle);
    graphics.setColor(Palette.pale(SightPainter.RANGE, 2 * SightPainter.RANGE_STRENGTH));
    graphics.fill(new Ellipse2D.Double(x, middle - 6.0, 12, 12));
    word(graphics, "detection range", x + 16, middle);
  }

  /** Writes a word and returns where the next thing may begin. */
  private static int word(Graphics2D graphics, String word, int x, int middle) {
    graphics.setColor(Palette.BLACK);
    graphics.drawString(word, x, middle + 4);
    return x + Fonts.width(word, Fonts.TEXT) + 14;
  }
}
