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
 * The lines of an SVG: {@code line}, {@code polyline}, {@code polygon}, {@code rect} and {@code
 * path}, moved as {@code transform} says; of curves, chords. Polygons and rectangles are solid.
 * Their {@code data-height} is a height in metres. What only describes ({@code defs}, {@code
 * symbol}, ...) is left out.
 */
final class SvgWalls extends PlainXml {
  private static final Set<String> HIDDEN =
      Set.of("defs", "symbol", "clipPath", "mask", "marker", "pattern");

  private static final Set<String> SOLID = Set.of("polygon", "rect");

  /** Metres, whatever the scale. */
  private static final String HEIGHT = "data-height";

  /** How far a chord may be off its curve, metres. */
  private static final double FLATNESS = 0.02;

  private final Path file;
  private final PictureFrame frame;
  private final WallCollector walls = new WallCollector(Unit.M, new LocalProjection());
  private final Deque<AffineTransform> transforms = new ArrayDeque<>(); // to metres
  private int hidden;

  SvgWalls(Path file, PictureFrame frame) {
    this.file = file;
    this.frame = frame;
  }

  /** All of them, in metres. */
  List<Obstacle> read() {
    readFile(file);
    return walls.all();
  }

  @Override
  public void startElement(String uri, String local, String qualified, Attributes attributes) {
    String name = plain(qualified);
    hidden += HIDDEN.contains(name) ? 1 : 0;
    if (transforms.isEmpty() && !name.equals("svg")) {
      throw place().error("the drawing is a <" + Place.shortened(name) + ">, expected an <svg>");
    }
    AffineTransform transform =
        transforms.isEmpty() ? toMetres(attributes) : new AffineTransform(transforms.peek());
    if (attributes.getValue("transform") != null) {
      transform.concatenate(
          parsed(attributes, name, "transform", AWTTransformProducer::createAffineTransform));
    }
    transforms.push(transform);
    if (hidden == 0) {
      int first = walls.count();
      add(shape(name, attributes), SOLID.contains(name));
      if (attributes.getValue(HEIGHT) != null) {
        walls.raise(place(), first, number(attributes, name, HEIGHT));
      }
    }
  }

  private static String plain(String qualified) {
    return qualified.substring(qualified.indexOf(':') + 1);
  }

  @Override
  public void endElement(String uri, String local, String qualified) {
    hidden -= HIDDEN.contains(plain(qualified)) ? 1 : 0;
    transforms.pop();
  }

  /** The drawing's lower edge is where its view box ends, or its height. */
  private AffineTransform toMetres(Attributes attributes) {
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

  /** Reads an attribute. */
  private interface Parser<T> {
    T parsed(String text) throws IOException;
  }

  private <T> T parsed(Attributes attributes, String element, String name, Parser<T> parser) {
    String text = text(attributes, element, name);
    try {
      return parser.parsed(text);
    } catch (IOException | RuntimeException e) { // Batik throws what it likes
      throw place().invalid("<" + element + "> " + name, text, "as SVG has it");
    }
  }

  /** What an element draws; nothing for one that is no shape. */
  private Shape shape(String name, Attributes attributes) {
    return switch (name) {
      case "line" ->
          new Line2D.Double(
              of(attributes, "x1"),
              of(attributes, "y1"),
              of(attributes, "x2"),
              of(attributes, "y2"));
      case "rect" ->
          new Rectangle2D.Double(
              of(attributes, "x"),
              of(attributes, "y"),
              of(attributes, "width"),
              of(attributes, "height"));
      case "polyline" -> drawn(attributes, name, "points", AWTPolylineProducer::createShape);
      case "polygon" -> drawn(attributes, name, "points", AWTPolygonProducer::createShape);
      case "path" -> drawn(attributes, name, "d", AWTPathProducer::createShape);
      default -> new Path2D.Double();
    };
  }

  /** Batik's reader of one kind of shape. */
  private interface Producer {
    Shape shape(Reader text, int windingRule) throws IOException;
  }

  private Shape drawn(Attributes attributes, String element, String name, Producer producer) {
    return text(attributes, element, name).isBlank()
        ? new Path2D.Double()
        : parsed(
            attributes,
            element,
            name,
            text -> producer.shape(new StringReader(text), PathIterator.WIND_NON_ZERO));
  }

  private double of(Attributes attributes, String name) {
    return attributes.getValue(name) == null ? 0 : number(attributes, "shape", name);
  }

  private void add(Shape shape, boolean solid) {
    List<Point> part = new ArrayList<>();
    double[] at = new double[6];
    PathIterator path =
        new FlatteningPathIterator(shape.getPathIterator(transforms.peek()), FLATNESS);
    for (; !path.isDone(); path.next()) {
      int segment = path.currentSegment(at);
      if (segment == PathIterator.SEG_MOVETO) {
        add(part, solid);
        part.clear();
      }
      part.add(segment == PathIterator.SEG_CLOSE ? part.get(0) : point(at[0], at[1]));
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
