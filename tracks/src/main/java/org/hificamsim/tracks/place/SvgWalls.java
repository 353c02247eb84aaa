package org.hificamsim.tracks.place;

import java.awt.Shape;
import java.awt.geom.AffineTransform;
import java.awt.geom.FlatteningPathIterator;
import java.awt.geom.Line2D;
import java.awt.geom.Path2D;
import java.awt.geom.PathIterator;
import java.awt.geom.Rectangle2D;
import java.io.IOException;
import java.io.Reader;
import java.io.StringReader;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import org.apache.batik.parser.AWTPathProducer;
import org.apache.batik.parser.AWTPolygonProducer;
import org.apache.batik.parser.AWTPolylineProducer;
import org.apache.batik.parser.AWTTransformProducer;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.PlainXml;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.LocalProjection;
import org.xml.sax.Attributes;

/**
 * Reads the shapes of an SVG as walls: {@code line}, {@code polyline}, {@code polygon}, {@code
 * rect} and {@code path}, with their {@code transform}. Curves become chords; polygons and
 * rectangles become solid obstacles. {@code data-height} is a height in metres. Elements that are
 * not drawn themselves ({@code defs}, {@code symbol}, ...) are ignored.
 */
final class SvgWalls extends PlainXml {
  private static final Set<String> HIDDEN =
      Set.of("defs", "symbol", "clipPath", "mask", "marker", "pattern");

  private static final Set<String> SOLID = Set.of("polygon", "rect");

  /** An attribute with the height in metres, independent of the scale. */
  private static final String HEIGHT = "data-height";

  /** The largest distance of a chord from its curve, metres. */
  private static final double FLATNESS = 0.02;

  private final Path file;
  private final PictureFrame frame;
  private final WallCollector walls = new WallCollector(Unit.M, new LocalProjection());
  private final Deque<AffineTransform> toMetres = new ArrayDeque<>();
  private int hiddenDepth;

  SvgWalls(Path file, PictureFrame frame) {
    this.file = file;
    this.frame = frame;
  }

  /** Returns all walls, in metres. */
  List<Obstacle> read() {
    readFile(file);
    return walls.obstacles();
  }

  @Override
  public void startElement(String uri, String local, String qualified, Attributes attributes) {
    String name = localName(qualified);
    hiddenDepth += HIDDEN.contains(name) ? 1 : 0;
    if (toMetres.isEmpty() && !name.equals("svg")) {
      throw place().error("the drawing is a <" + Place.shortened(name) + ">, expected an <svg>");
    }
    AffineTransform transform =
        toMetres.isEmpty() ? drawingToMetres(attributes) : new AffineTransform(toMetres.peek());
    if (attributes.getValue("transform") != null) {
      transform.concatenate(
          parsed(attributes, name, "transform", AWTTransformProducer::createAffineTransform));
    }
    toMetres.push(transform);
    if (hiddenDepth == 0) {
      int first = walls.count();
      add(shape(name, attributes), SOLID.contains(name));
      if (attributes.getValue(HEIGHT) != null) {
        walls.raise(place(), first, number(attributes, name, HEIGHT));
      }
    }
  }

  private static String localName(String qualified) {
    return qualified.substring(qualified.indexOf(':') + 1);
  }

  @Override
  public void endElement(String uri, String local, String qualified) {
    hiddenDepth -= HIDDEN.contains(localName(qualified)) ? 1 : 0;
    toMetres.pop();
  }

  /** The lower edge of the drawing is the end of its view box, or else its height. */
  private AffineTransform drawingToMetres(Attributes attributes) {
    double[] box = {0, 0, 0, 0};
    if (attributes.getValue("viewBox") != null) {
      box = parsed(attributes, "svg", "viewBox", text -> numbers(text, 4));
    } else {
      String element = "svg without viewBox";
      box[3] =
          parsed(
              attributes,
              element,
              "height",
              text -> numbers(text.strip().replaceFirst("px$", ""), 1))[0];
    }
    AffineTransform transform = new AffineTransform();
    transform.translate(frame.x(), frame.y());
    transform.scale(frame.scale(), -frame.scale());
    transform.translate(-box[0], -(box[1] + box[3]));
    return transform;
  }

  private static double[] numbers(String text, int count) {
    double[] numbers =
        Arrays.stream(text.strip().split("[\\s,]+")).mapToDouble(Double::parseDouble).toArray();
    if (numbers.length != count) {
      throw new NumberFormatException(text);
    }
    return numbers;
  }

  /** Parses the text of an attribute. */
  private interface Parser<T> {
    T parse(String text) throws IOException;
  }

  private <T> T parsed(Attributes attributes, String element, String name, Parser<T> parser) {
    String text = text(attributes, element, name);
    try {
      return parser.parse(text);
    } catch (IOException | RuntimeException e) { // Batik throws exceptions of any kind
      throw place().invalid("<" + element + "> " + name, text, "a value as in SVG");
    }
  }

  /** The shape of an element; empty for an element that is not a shape. */
  private Shape shape(String name, Attributes attributes) {
    return switch (name) {
      case "line" ->
          new Line2D.Double(
              coordinate(attributes, "x1"),
              coordinate(attributes, "y1"),
              coordinate(attributes, "x2"),
              coordinate(attributes, "y2"));
      case "rect" ->
          new Rectangle2D.Double(
              coordinate(attributes, "x"),
              coordinate(attributes, "y"),
              coordinate(attributes, "width"),
              coordinate(attributes, "height"));
      case "polyline" ->
          producedShape(attributes, name, "points", AWTPolylineProducer::createShape);
      case "polygon" -> producedShape(attributes, name, "points", AWTPolygonProducer::createShape);
      case "path" -> producedShape(attributes, name, "d", AWTPathProducer::createShape);
      default -> new Path2D.Double();
    };
  }

  /** Batik's parser of one kind of shape. */
  private interface Producer {
    Shape shape(Reader text, int windingRule) throws IOException;
  }

  private Shape producedShape(
      Attributes attributes, String element, String name, Producer producer) {
    return text(attributes, element, name).isBlank()
        ? new Path2D.Double()
        : parsed(
            attributes,
            element,
            name,
            text -> producer.shape(new StringReader(text), PathIterator.WIND_NON_ZERO));
  }

  private double coordinate(Attributes attributes, String name) {
    return attributes.getValue(name) == null ? 0 : number(attributes, "shape", name);
  }

  private void add(Shape shape, boolean solid) {
    List<Point> part = new ArrayList<>();
    double[] coordinates = new double[6];
    PathIterator path =
        new FlatteningPathIterator(shape.getPathIterator(toMetres.peek()), FLATNESS);
    for (; !path.isDone(); path.next()) {
      int segment = path.currentSegment(coordinates);
      if (segment == PathIterator.SEG_MOVETO) {
        add(part, solid);
        part.clear();
      }
      part.add(
          segment == PathIterator.SEG_CLOSE ? part.get(0) : point(coordinates[0], coordinates[1]));
    }
    add(part, solid);
  }

  private void add(List<Point> part, boolean solid) {
    if (solid) {
      walls.ring(part);
    } else {
      walls.line(part);
    }
  }

  private Point point(double x, double y) {
    if (!(Math.abs(x) <= 1e9 && Math.abs(y) <= 1e9)) {
      throw place().error("a point is at %s, %s, expected numbers from -1e9 to 1e9", x, y);
    }
    return WallCollector.rounded(x, y);
  }
}
