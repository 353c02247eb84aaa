package org.hificamsim.tracks.place;

import java.awt.geom.AffineTransform;
import java.util.Arrays;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;

/**
 * The rectangle that lengths in per cent refer to, in units of the drawing.
 *
 * @param width NaN if it is not known
 * @param height NaN if it is not known
 */
record SvgViewport(double width, double height) {
  double diagonal() {
    return Math.hypot(width, height) / Math.sqrt(2);
  }

  /** Returns the viewport inside an element: its view box, or else its size. */
  static SvgViewport inside(SvgNode node, double width, double height) {
    double[] box = viewBox(node);
    return box == null ? new SvgViewport(width, height) : new SvgViewport(box[2], box[3]);
  }

  /** Reads a view box: x, y, width and height; null if there is none. */
  static double[] viewBox(SvgNode node) {
    if (!node.has("viewBox")) {
      return null;
    }
    double[] box = numbers(node, "viewBox");
    if (box.length != 4) {
      throw invalid(node, "viewBox");
    }
    return box;
  }

  private static double[] numbers(SvgNode node, String attribute) {
    try {
      return Arrays.stream(node.text(attribute).split("[\\s,]+"))
          .mapToDouble(Double::parseDouble)
          .toArray();
    } catch (NumberFormatException e) {
      throw invalid(node, attribute).because(e);
    }
  }

  static InputException invalid(SvgNode node, String attribute) {
    return node.place()
        .invalid(
            "<" + Place.shortened(node.name()) + "> " + attribute,
            node.text(attribute),
            "a value as in SVG");
  }

  /**
   * Returns the transform from a view box into a viewport of some size, by {@code
   * preserveAspectRatio}; none without a view box.
   */
  static AffineTransform fit(SvgNode node, double width, double height) {
    double[] box = viewBox(node);
    if (box == null || !(box[2] > 0 && box[3] > 0 && width > 0 && height > 0)) {
      return new AffineTransform();
    }
    String fit = node.has("preserveAspectRatio") ? node.text("preserveAspectRatio") : "xMidYMid";
    double scaleX = width / box[2];
    double scaleY = height / box[3];
    if (!fit.contains("none")) {
      double scale = fit.contains("slice") ? Math.max(scaleX, scaleY) : Math.min(scaleX, scaleY);
      scaleX = scale;
      scaleY = scale;
    }
    AffineTransform transform = new AffineTransform();
    transform.translate(
        share(fit, "x") * (width - scaleX * box[2]), share(fit, "Y") * (height - scaleY * box[3]));
    transform.scale(scaleX, scaleY);
    transform.translate(-box[0], -box[1]);
    return transform;
  }

  /** The share of the free room that is before the picture: 0, a half or 1. */
  private static double share(String fit, String axis) {
    return fit.contains("none") || fit.contains(axis + "Min")
        ? 0
        : fit.contains(axis + "Max") ? 1 : 0.5;
  }
}
