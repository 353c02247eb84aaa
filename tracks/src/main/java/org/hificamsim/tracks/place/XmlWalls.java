package org.hificamsim.tracks.place;

import java.util.List;
import org.hificamsim.core.file.PlainXml;
import org.xml.sax.Attributes;

/** Elements {@code <Line x1="" y1="" x2="" y2=""/>}, wherever they stand. */
final class XmlWalls extends PlainXml {
  private final WallCollector walls;

  XmlWalls(WallCollector walls) {
    this.walls = walls;
  }

  @Override
  public void startElement(String uri, String local, String name, Attributes attributes) {
    if (name.equals("Line")) {
      walls.line(
          List.of(
              walls.point(place(), number(attributes, name, "x1"), number(attributes, name, "y1")),
              walls.point(
                  place(), number(attributes, name, "x2"), number(attributes, name, "y2"))));
    }
  }
}
