package org.hificamsim.tracks.place;

import static org.hificamsim.core.NamedSetting.setting;

import java.nio.file.Path;
import java.util.List;
import java.util.Locale;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.core.file.PlainXml;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.LocalProjection;
import org.xml.sax.Attributes;

/**
 * Reads walls from GeoJSON, well-known text, XML with {@code Line} elements, or SVG, according to
 * the ending of the file.
 */
public final class WallFile {
  private WallFile() {}

  /**
   * Reads the walls.
   *
   * @param unit of coordinates, except in SVG
   * @param projection of degrees
   * @param frame of an SVG; empty if its scale is not known
   * @throws InputException with the place, if the file is wrong
   */
  public static List<Obstacle> read(
      Path file, Unit unit, LocalProjection projection, Optional<PictureFrame> frame) {
    String name = file.toString().toLowerCase(Locale.ROOT);
    if (unit == Unit.PX && !name.endsWith(".svg")) {
      throw InputException.of(
          "%s: %s is px, expected m, cm, mm or deg: a homography is not applied to walls",
          file, setting("walls_unit"));
    }
    WallCollector walls = new WallCollector(unit, projection);
    if (name.endsWith(".json") || name.endsWith(".geojson")) {
      new GeoJsonWalls(walls).read(file);
    } else if (name.endsWith(".wkt")) {
      new WktWalls(walls).read(file);
    } else if (name.endsWith(".xml")) {
      new XmlWalls(walls).readFile(file);
    } else if (name.endsWith(".svg")) {
      return new SvgWalls(file, frame.orElseThrow(() -> noScale(file))).read();
    } else {
      throw InputException.of(
          "%s: expected walls in a file that ends in .geojson, .json, .wkt, .xml or .svg", file);
    }
    return walls.obstacles();
  }

  private static InputException noScale(Path file) {
    return InputException.of(
        "%s: expected %s with an SVG, the metres of a unit of the drawing",
        file, setting("scale", "M"));
  }

  /** Reads all elements {@code <Line x1="" y1="" x2="" y2=""/>}. */
  private static final class XmlWalls extends PlainXml {
    private final WallCollector walls;

    XmlWalls(WallCollector walls) {
      this.walls = walls;
    }

    @Override
    public void startElement(String uri, String local, String name, Attributes attributes) {
      if (name.equals("Line")) {
        int first = walls.count();
        walls.line(
            List.of(
                walls.point(
                    place(), number(attributes, name, "x1"), number(attributes, name, "y1")),
                walls.point(
                    place(), number(attributes, name, "x2"), number(attributes, name, "y2"))));
        if (attributes.getValue("height") != null) {
          walls.raise(place(), first, number(attributes, name, "height"));
        }
      }
    }
  }
}
