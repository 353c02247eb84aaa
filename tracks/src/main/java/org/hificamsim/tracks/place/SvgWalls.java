package org.hificamsim.tracks.place;

import java.awt.geom.AffineTransform;
import java.nio.file.Path;
import java.util.ArrayDeque;
import java.util.ArrayList;
import java.util.Deque;
import java.util.List;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.file.PlainXml;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Point;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.LocalProjection;
import org.hificamsim.tracks.place.SvgText.SvgPath;
import org.xml.sax.Attributes;

/**
 * The lines of an SVG: {@code line}, {@code polyline}, {@code polygon}, {@code rect}, and {@code
 * path} of straight parts, moved as {@code transform} says. Polygons and rectangles are solid.
 * Their {@code data-height} is a height in metres. What only describes ({@code defs}, {@code
 * symbol}, ...) is left out.
 */
final class SvgWalls extends PlainXml {
  private static final Set<String> HIDDEN =
      Set.of("defs", "symbol", "clipPath", "mask", "marker", "pattern");

  /** Metres, whatever the scale. */
  private static final String HEIGHT = "data-height";

  private final Path file;
  private final PictureFrame frame;
  private final WallCollector walls = new WallCollector(Unit.M, new LocalProjection());
  private final Deque<AffineTransform> transforms = new ArrayDeque<>();
  private double minX;
  private double minY;
  private double height = Double.NaN;
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
    if (transforms.isEmpty()) {
      if (!name.equals("svg")) {
        throw place().error("the drawing is a <" + Place.shortened(name) + ">, expected an <svg>");
      }
      size(attributes);
    }
    AffineTransform transform =
        transforms.isEmpty() ? new AffineTransform() : new AffineTransform(transforms.peek());
    String own = attributes.getValue("transform");
    if (own != null) {
      transform.concatenate(SvgText.transform(own, () -> invalid(name, "transform", own)));
    }
    transforms.push(transform);
    if (hidden == 0) {
      int first = walls.count();
      shape(name, attributes);
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
  private void size(Attributes attributes) {
    String box = attributes.getValue("viewBox");
    if (box != null) {
      double[] numbers = SvgText.numbers(box);
      if (numbers.length != 4) {
        throw invalid("svg", "viewBox", box);
      }
      minX = numbers[0];
      minY = numbers[1];
      height = numbers[3];
    } else {
      String text = text(attributes, "svg without viewBox", "height");
      double[] numbers = SvgText.numbers(text.replaceFirst("(px)?\\s*$", ""));
      if (numbers.length != 1) {
        throw invalid("svg", "height", text);
      }
      height = numbers[0];
    }
  }

  private InputException invalid(String element, String attribute, String value) {
    return place().invalid("<" + element + "> " + attribute, value, "as SVG has it");
  }

  private void shape(String name, Attributes attributes) {
    switch (name) {
      case "line" ->
          walls.line(
              List.of(
                  point(of(attributes, "x1"), of(attributes, "y1")),
                  point(of(attributes, "x2"), of(attributes, "y2"))));
      case "polyline" -> walls.line(points(name, text(attributes, name, "points")));
      case "polygon" -> walls.ring(points(name, text(attributes, name, "points")));
      case "rect" -> rectangle(attributes);
      case "path" -> path(text(attributes, name, "d"));
      default -> {}
    }
  }

  private double of(Attributes attributes, String name) {
    return attributes.getValue(name) == null ? 0 : number(attributes, "shape", name);
  }

  private Point point(double x, double y) {
    double[] at = {x, y};
    transforms.peek().transform(at, 0, at, 0, 1);
    if (!(Math.abs(at[0]) <= 1e9 && Math.abs(at[1]) <= 1e9)) {
      throw place()
          .error("a point is at %s, %s, expected numbers from -1e9 to 1e9".formatted(at[0], at[1]));
    }
    return WallCollector.rounded(
        frame.x() + (at[0] - minX) * frame.scale(),
        frame.y() + (minY + height - at[1]) * frame.scale());
  }

  private List<Point> points(String name, String text) {
    double[] numbers = SvgText.numbers(text);
    if (numbers.length % 2 == 1 || (numbers.length == 0 && !text.isBlank())) {
      throw invalid(name, "points", text);
    }
    List<Point> points = new ArrayList<>();
    for (int i = 0; i < numbers.length; i += 2) {
      points.add(point(numbers[i], numbers[i + 1]));
    }
    return points;
  }

  private void rectangle(Attributes attributes) {
    double x = of(attributes, "x");
    double y = of(attributes, "y");
    double right = x + of(attributes, "width");
    double lower = y + of(attributes, "height");
    walls.ring(List.of(point(x, y), point(right, y), point(right, lower), point(x, lower)));
  }

  private void path(String d) {
    SvgPath path =
        new SvgPath(
            d,
            letter ->
                place()
                    .error(
                        "<path> has the command %s, expected straight ones: M, L, H, V, Z. A"
                            + " drawing program makes lines of curves",
                        letter));
    path.parts()
        .forEach(part -> walls.line(part.stream().map(at -> point(at.x(), at.y())).toList()));
  }
}
