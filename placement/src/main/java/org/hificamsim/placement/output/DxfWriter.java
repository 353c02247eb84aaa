package org.hificamsim.placement.output;

import java.awt.geom.PathIterator;
import java.io.IOException;
import java.io.Writer;
import java.util.ArrayList;
import java.util.List;
import org.hificamsim.core.Texts;
import org.hificamsim.core.obstacle.Point;

/**
 * Writes a drawing as ASCII DXF of release 12, which all CAD programs read. Such a file consists of
 * pairs: a group code and, in the next line, its value.
 */
record DxfWriter(Writer out) {
  void pair(int code, Object value) throws IOException {
    out.write(code + "\n" + value + "\n");
  }

  void number(int code, double value) throws IOException {
    pair(code, Texts.format("%.6f", value));
  }

  /** Writes a text. Characters beyond ASCII are escaped, as in {@code \U+00E4}. */
  void text(int code, String text) throws IOException {
    StringBuilder escaped = new StringBuilder();
    for (int i = 0; i < text.length(); i++) {
      char character = text.charAt(i);
      boolean isPlain = character >= ' ' && character <= '~';
      escaped.append(
          isPlain ? String.valueOf(character) : Texts.format("\\U+%04X", (int) character));
    }
    pair(code, escaped);
  }

  void point(int code, double x, double y) throws IOException {
    number(code, x);
    number(code + 10, y);
    number(code + 20, 0);
  }

  void begin(String section) throws IOException {
    pair(0, "SECTION");
    pair(2, section);
  }

  void end() throws IOException {
    pair(0, "ENDSEC");
  }

  void entity(String type, String layer) throws IOException {
    pair(0, type);
    pair(8, layer);
  }

  void line(String layer, Point from, Point to) throws IOException {
    entity("LINE", layer);
    point(10, from.x(), from.y());
    point(11, to.x(), to.y());
  }

  void circle(String layer, Point centre, double radius) throws IOException {
    entity("CIRCLE", layer);
    point(10, centre.x(), centre.y());
    number(40, radius);
  }

  void polyline(String layer, List<Point> corners, boolean isClosed) throws IOException {
    entity("POLYLINE", layer);
    pair(66, 1);
    point(10, 0, 0);
    pair(70, isClosed ? 1 : 0);
    for (Point corner : corners) {
      entity("VERTEX", layer);
      point(10, corner.x(), corner.y());
    }
    entity("SEQEND", layer);
  }

  /** Writes each closed part of a path without curves. */
  void path(String layer, PathIterator path) throws IOException {
    List<Point> part = new ArrayList<>();
    double[] coordinates = new double[6];
    for (; !path.isDone(); path.next()) {
      int segment = path.currentSegment(coordinates);
      if (segment != PathIterator.SEG_CLOSE) {
        part.add(new Point(coordinates[0], coordinates[1]));
      } else if (!part.isEmpty()) {
        polyline(layer, part, true);
        part = new ArrayList<>();
      }
    }
  }

  void label(String layer, Point place, double height, String text) throws IOException {
    entity("TEXT", layer);
    point(10, place.x(), place.y());
    number(40, height);
    text(1, text);
  }
}
