package org.hificamsim.tracks.place;

import static org.hificamsim.core.NamedSetting.setting;

import java.nio.file.Path;
import java.util.Locale;
import org.hificamsim.core.InputException;
import org.hificamsim.tracks.format.Unit;

/**
 * Reads walls from SVG, DXF, GeoJSON, well-known text or XML, according to the ending of the file,
 * before {@code .gz} if it is packed.
 */
public final class WallFile {
  private static final String ENDINGS = ".svg, .svgz, .dxf, .geojson, .json, .wkt or .xml";

  private WallFile() {}

  /**
   * Reads a drawing or map with at least one shape that is chosen.
   *
   * @throws InputException with the place, if the file is wrong
   */
  public static Drawing read(Path file, DrawingSettings settings) {
    String name = file.toString().toLowerCase(Locale.ROOT).replaceFirst("\\.gz$", "");
    boolean isDrawing = name.matches(".*\\.(svgz?|dxf)");
    if (settings.points().unit() == Unit.PX && !isDrawing) {
      throw InputException.of(
          "%s: %s is px, expected m, cm, mm or deg: a homography is not applied to walls",
          file, setting("walls_unit"));
    }
    return drawing(file, name, settings).complete();
  }

  private static Drawing drawing(Path file, String name, DrawingSettings settings) {
    Drawing drawing = new Drawing(file, settings.choice());
    if (name.endsWith(".json") || name.endsWith(".geojson")) {
      new GeoJsonWalls(drawing, settings.points()).read(file);
    } else if (name.endsWith(".wkt")) {
      new WktWalls(drawing, settings.points()).read(file);
    } else if (name.endsWith(".xml")) {
      new XmlWalls(drawing, settings).readFile(file);
    } else if (name.endsWith(".dxf")) {
      return new DxfReader(file, settings).read();
    } else if (name.endsWith(".svg") || name.endsWith(".svgz")) {
      return new SvgReader(file, settings.choice())
          .read(settings.frame().orElseThrow(() -> noScale(file)));
    } else {
      throw InputException.of("%s: expected walls in a file that ends in %s", file, ENDINGS);
    }
    return drawing;
  }

  private static InputException noScale(Path file) {
    return InputException.of(
        "%s: expected %s with an SVG, the metres of a unit of the drawing",
        file, setting("scale", "M"));
  }
}
