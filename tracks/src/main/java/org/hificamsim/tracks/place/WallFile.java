package org.hificamsim.tracks.place;

import static org.hificamsim.core.NamedSetting.setting;

import java.nio.file.Path;
import java.util.Locale;
import java.util.Set;
import org.hificamsim.core.InputException;
import org.hificamsim.tracks.format.Unit;

/**
 * Reads walls from SVG, DXF, GeoJSON, well-known text, tables, SQLite or XML, according to the
 * ending of the file, before {@code .gz} if it is packed.
 */
public final class WallFile {
  private static final String ENDINGS =
      ".svg, .svgz, .dxf, .geojson, .json, .wkt, .csv, .sqlite or .xml";

  private static final Set<String> SQLITE = Set.of(".sqlite", ".sqlite3", ".db");

  private WallFile() {}

  /**
   * Reads a drawing or map with at least one shape that is chosen.
   *
   * @throws InputException with the place, if the file is wrong
   */
  public static Drawing read(Path file, DrawingSettings settings) {
    boolean isDrawing = isDxf(file) || isSvg(file);
    if (settings.points().unit() == Unit.PX && !isDrawing) {
      throw InputException.of(
          "%s: %s is px, expected m, cm, mm or deg: a homography is not applied to walls",
          file, setting("walls_unit"));
    }
    return drawing(file, settings).complete();
  }

  /** Whether a file is a DXF, by its ending. */
  public static boolean isDxf(Path file) {
    return ending(file).equals(".dxf");
  }

  /** Whether a file is GeoJSON, by its ending. */
  public static boolean isGeoJson(Path file) {
    return ending(file).equals(".geojson") || ending(file).equals(".json");
  }

  private static boolean isSvg(Path file) {
    return ending(file).equals(".svg") || ending(file).equals(".svgz");
  }

  /** The ending of a file that may be packed, in lower case; the name if it has none. */
  private static String ending(Path file) {
    String name = file.toString().toLowerCase(Locale.ROOT).replaceFirst("\\.gz$", "");
    return name.substring(Math.max(0, name.lastIndexOf('.')));
  }

  private static Drawing drawing(Path file, DrawingSettings settings) {
    Drawing drawing = new Drawing(file, settings.choice());
    if (isGeoJson(file)) {
      new GeoJsonWalls(drawing, settings.points()).read(file);
    } else if (ending(file).equals(".wkt")) {
      new WktWalls(new WktShapes(drawing, settings.points(), false)).read(file);
    } else if (ending(file).equals(".csv") || ending(file).equals(".tsv")) {
      new CsvWalls(drawing, new WktShapes(drawing, settings.points(), false)).read(file);
    } else if (SQLITE.contains(ending(file))) {
      new SqliteWalls(new WktShapes(drawing, settings.points(), true)).read(file);
    } else if (ending(file).equals(".xml")) {
      new XmlWalls(drawing, settings).readFile(file);
    } else if (isDxf(file)) {
      return new DxfReader(file, settings).read();
    } else if (isSvg(file)) {
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
