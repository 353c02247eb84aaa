package org.hificamsim.presentation.picture;

import java.awt.Color;
import java.awt.image.BufferedImage;
import org.hificamsim.core.scenario.spec.Field;

/** Where metres of a field are in a picture of one pixel a point. */
record Places(Field field) {
  private static final double WIDTH = StepPicture.WIDTH - 2.0 * StepPicture.MARGIN;
  private static final double ACROSS = 46; // for the numbers at the left, points
  private static final double DOWN = 36;

  /** Points per metre, where the field is as wide as the picture allows. */
  double scale() {
    return (WIDTH - 2 * ACROSS) / field.width();
  }

  double x(double metres) {
    return StepPicture.MARGIN + ACROSS + scale() * (metres - field.minX());
  }

  double y(double metres) {
    return StepPicture.HEADING + DOWN + scale() * (field.maxY() - metres);
  }

  Color color(BufferedImage image, double x, double y) {
    return new Color(image.getRGB((int) Math.round(x(x)), (int) Math.round(y(y))));
  }
}
