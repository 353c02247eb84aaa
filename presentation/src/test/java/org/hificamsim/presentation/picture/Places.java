package org.hificamsim.presentation.picture;

import java.awt.Color;
import java.awt.image.BufferedImage;
import org.hificamsim.core.scenario.spec.Field;

/** Converts metres of a field to pixels of a picture with one pixel per point. */
record Places(Field field) {
  private static final double WIDTH = StepPicture.WIDTH - 2.0 * StepPicture.MARGIN;
  private static final double LEFT = 46; // for the numbers at the left, points
  private static final double DOWN = 36;

  /** Points per metre if the field takes the whole width. */
  double scale() {
    return (WIDTH - 2 * LEFT) / field.width();
  }

  double x(double metres) {
    return StepPicture.MARGIN + LEFT + scale() * (metres - field.minX());
  }

  double y(double metres) {
    return StepPicture.HEADING_HEIGHT + DOWN + scale() * (field.maxY() - metres);
  }

  Color color(BufferedImage image, double x, double y) {
    return new Color(image.getRGB((int) Math.round(x(x)), (int) Math.round(y(y))));
  }
}
