package org.hificamsim.tracks.place;

import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.Ellipse2D;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.PathIterator;
import java.awt.geom.Rectangle2D;
import java.awt.geom.RoundRectangle2D;
import java.io.IOException;
import java.io.Reader;
import java.io.StringReader;
import org.apache.batik.parser.AWTPathProducer;
import org.apache.batik.parser.AWTPolygonProducer;
import org.apache.batik.parser.AWTPolylineProducer;
import org.apache.batik.parser.AWTTransformProducer;

/**
 * The geometry of an element of an SVG.
 *
 * @param viewport the viewport to which lengths in per cent refer
 */
record SvgShapes(SvgNode node, SvgViewport viewport) {
  /** The shape; empty for an element that is none, or that has no size. */
  Shape shape() {
    return switch (node.name()) {
      case "line" -> new Line2D.Double(x("x1"), y("y1"), x("x2"), y("y2"));
      case "rect" -> rectangle();
      case "circle" -> ellipse(radius("r", viewport.diagonal()), radius("r", viewport.diagonal()));
      case "ellipse" ->
          ellipse(
              radius(node.has("rx") ? "rx" : "ry", viewport.width()),
              radius(node.has("ry") ? "ry" : "rx", viewport.height()));
      case "polyline" -> produced("points", AWTPolylineProducer::createShape);
      case "polygon" -> produced("points", AWTPolygonProducer::createShape);
      case "path" -> produced("d", AWTPathProducer::createShape);
      default -> new Path2D.Double();
    };
  }

  private Shape rectangle() {
    double width = length("width", viewport.width(), 0);
    double height = length("height", viewport.height(), 0);
    double radiusX = radius(node.has("rx") ? "rx" : "ry", viewport.width());
    double radiusY = radius(node.has("ry") ? "ry" : "rx", viewport.height());
    return radiusX > 0 && radiusY > 0
        ? new RoundRectangle2D.Double(x("x"), y("y"), width, height, 2 * radiusX, 2 * radiusY)
        : new Rectangle2D.Double(x("x"), y("y"), width, height);
  }

  private Shape ellipse(double radiusX, double radiusY) {
    return new Ellipse2D.Double(x("cx") - radiusX, y("cy") - radiusY, 2 * radiusX, 2 * radiusY);
  }

  private double radius(String attribute, double fullLength) {
    return node.text(attribute).equals("auto") ? 0 : length(attribute, fullLength, 0);
  }

  private double x(String attribute) {
    return length(attribute, viewport.width(), 0);
  }

  private double y(String attribute) {
    return length(attribute, viewport.height(), 0);
  }

  /**
   * Reads a length.
   *
   * @param fullLength the length of 100 %
   * @param usual the length if the attribute is missing
   */
  double length(String attribute, double fullLength, double usual) {
    String text = node.text(attribute);
    if (!node.has(attribute)) {
      return usual;
    }
    double pixels =
        SvgLength.pixels(
            text, text.endsWith("%") ? requireKnown(attribute, fullLength) : fullLength);
    if (Double.isNaN(pixels)) {
      throw SvgViewport.invalid(node, attribute);
    }
    return pixels;
  }

  private double requireKnown(String attribute, double fullLength) {
    if (Double.isNaN(fullLength)) {
      throw node.place()
          .error(
              "<%s> %s is '%s' of a drawing without a size, expected an <svg> with a viewBox",
              node.name(), attribute, node.text(attribute));
    }
    return fullLength;
  }

  /** The transform of the element; none without one. */
  AffineTransform transform() {
    return node.text("transform").isEmpty()
        ? new AffineTransform()
        : parsed("transform", AWTTransformProducer::createAffineTransform);
  }

  /** Batik's parser of one kind of shape. */
  private interface Producer {
    Shape shape(Reader text, int windingRule) throws IOException;
  }

  private Shape produced(String attribute, Producer producer) {
    return node.text(attribute).isEmpty() || node.text(attribute).equals("none")
        ? new Path2D.Double()
        : parsed(
            attribute, text -> producer.shape(new StringReader(text), PathIterator.WIND_NON_ZERO));
  }

  /** Parses the text of an attribute. */
  private interface Parser<T> {
    T parse(String text) throws IOException;
  }

  private <T> T parsed(String attribute, Parser<T> parser) {
    try {
      return parser.parse(node.text(attribute));
    } catch (IOException | RuntimeException e) { // Batik throws exceptions of any kind
      throw SvgViewport.invalid(node, attribute).because(e);
    }
  }
}
