package org.hificamsim.presentation.picture;

import java.awt.Color;
import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Path2D;
import java.awt.geom.Rectangle2D;
import java.util.Arrays;
import java.util.stream.IntStream;
import org.hificamsim.presentation.plot.Palette;

/**
 * How many cameras cover a target, as colour, shape and width of its trail: those of the page's
 * {@code palette.js}.
 */
enum CoverClass {
  NONE(
      "no camera",
      Palette.VERMILION,
      1.2f,
      polygon(
          new double[][] {
            {-1, -0.55}, {-0.55, -1}, {0, -0.45}, {0.55, -1}, {1, -0.55}, {0.45, 0},
            {1, 0.55}, {0.55, 1}, {0, 0.45}, {-0.55, 1}, {-1, 0.55}, {-0.45, 0}
          })),
  ONE("1 camera", Palette.ORANGE, 2, polygon(new double[][] {{0, -1.15}, {1.1, 0.8}, {-1.1, 0.8}})),
  TWO("2 cameras", Palette.SKY, 3, new Rectangle2D.Double(-0.9, -0.9, 1.8, 1.8)),
  MORE("3 or more", Palette.GREEN, 4.5f, new Ellipse2D.Double(-1, -1, 2, 2));

  private static final int SHADES = 6;

  private final String label;
  private final Color color;
  private final float trail;

  /** About the origin, a unit in each direction. */
  @SuppressWarnings("ImmutableEnumChecker") // nobody changes it
  private final Shape unit;

  CoverClass(String label, Color color, float trail, Shape unit) {
    this.label = label;
    this.color = color;
    this.trail = trail;
    this.unit = unit;
  }

  /** The class of a target that k cameras cover. */
  static CoverClass of(int k) {
    return values()[Math.min(k, values().length - 1)];
  }

  String label() {
    return label;
  }

  Color color() {
    return color;
  }

  /** Width of the trail, points. */
  float trail() {
    return trail;
  }

  /** The colours as trails fade on a white ground and on a detected one, as 0xRRGGBB. */
  static IntStream shades() {
    return Arrays.stream(values())
        .flatMapToInt(
            cover ->
                IntStream.rangeClosed(1, SHADES)
                    .flatMap(
                        i ->
                            IntStream.of(
                                mixed(cover.color, Color.WHITE, i),
                                mixed(cover.color, FieldPainter.DETECTED, i))));
  }

  private static int mixed(Color color, Color ground, int shade) {
    int rgb = 0;
    for (int shift : new int[] {16, 8, 0}) {
      int from = ground.getRGB() >> shift & 255;
      int to = color.getRGB() >> shift & 255;
      rgb |= (from + (to - from) * shade / SHADES) << shift;
    }
    return rgb;
  }

  /** The shape of this radius at a place. */
  Shape at(double x, double y, double radius) {
    AffineTransform place = AffineTransform.getTranslateInstance(x, y);
    place.scale(radius, radius);
    return place.createTransformedShape(unit);
  }

  private static Shape polygon(double[][] corners) {
    Path2D path = new Path2D.Double();
    path.moveTo(corners[0][0], corners[0][1]);
    for (int i = 1; i < corners.length; i++) {
      path.lineTo(corners[i][0], corners[i][1]);
    }
    path.closePath();
    return path;
  }
}
