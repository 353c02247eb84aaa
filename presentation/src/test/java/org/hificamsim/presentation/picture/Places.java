package org.hificamsim.presentation.picture;

import java.awt.Color;
import java.awt.image.BufferedImage;
import org.hificamsim.core.scenario.spec.Field;

/** Converts metres of a field to pixels of a picture with one pixel per point. */
record Places(Field field) {
  private static final double WIDTH = StepPicture.WIDTH - 2.0 * StepPicture.MARGIN;

  /** The space for numbers at the left, in points. */
  private static final double LEFT_SPACE = 46;

  /** The space above the field, in points. */
  private static final double TOP_SPACE = 36;

  /** Returns the points per metre of a field that takes the whole width. */
  double scale() {
    return (WIDTH - 2 * LEFT_SPACE) / field.width();
  }

  double x(double metres) {
    return StepPicture.MARGIN + LEFT_SPACE + scale() * (metres - field.minX());
  }

  double y(double metres) {
    return StepPicture.HEADING_HEIGHT + TOP_SPACE + scale() * (field.maxY() - metres);
  }

  Color color(BufferedImage image, double x, double y) {
    return new Color(image.getRGB((int) Math.round(x(x)), (int) Math.round(y(y))));
  }
}
