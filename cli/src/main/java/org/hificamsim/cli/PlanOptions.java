package org.hificamsim.cli;

import java.io.PrintWriter;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.Ranges;
import org.hificamsim.core.Texts;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Floorplan;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.LocalProjection;
import org.hificamsim.tracks.place.Drawing;
import org.hificamsim.tracks.place.DrawingSettings;
import org.hificamsim.tracks.place.LayerChoice;
import org.hificamsim.tracks.place.PictureFrame;
import org.hificamsim.tracks.place.PlanScale;
import org.hificamsim.tracks.place.WallFile;
import picocli.CommandLine.Option;

/** The options about drawings of walls and pictures of floor plans. */
final class PlanOptions {
  private static final double MAX_METRES = 1e9;

  @Option(names = "--walls-unit", paramLabel = "U")
  private String wallsUnit;

  @Option(names = "--layers", split = ",", paramLabel = "NAME")
  private List<String> layers = new ArrayList<>();

  @Option(names = "--list-layers")
  private boolean listLayers;

  @Option(names = "--walkable")
  private boolean walkable;

  @Option(names = "--floorplan", paramLabel = "IMAGE")
  private Optional<Path> floorplan;

  @Option(names = "--scale", paramLabel = "M")
  private String scale;

  @Option(names = "--width", paramLabel = "M")
  private Double width;

  @Option(names = "--at", paramLabel = "X,Y")
  private String at;

  /** Whether only the layers of the walls are asked for. */
  boolean listsLayers() {
    return listLayers;
  }

  /** Whether people walk in the outermost areas, which are solid otherwise. */
  boolean walkable() {
    return walkable;
  }

  /**
   * Reads a drawing of walls.
   *
   * @param usualUnit the unit of maps that name none
   */
  Drawing read(Path file, Unit usualUnit, LocalProjection projection) {
    Optional<Unit> unit =
        wallsUnit == null
            ? Optional.empty()
            : Optional.of(RecordingOptions.unit("--walls-unit", wallsUnit));
    LayerChoice choice = listLayers ? LayerChoice.FOR_LIST : new LayerChoice(layers);
    boolean isDxf = WallFile.isDxf(file);
    // a DXF has a unit of its own, so that the scale is that of the picture
    boolean isForPicture = isDxf && floorplan.isPresent();
    if (isDxf && !isForPicture && wallsUnit != null && (scale != null || width != null)) {
      throw new InputException(
          "--walls-unit and %s are given, expected one of them"
              .formatted(scale != null ? "--scale" : "--width"));
    }
    Optional<PictureFrame> frame = isForPicture ? Optional.empty() : frame();
    if (listLayers && frame.isEmpty()) {
      frame = Optional.of(new PictureFrame(new PlanScale.PerUnit(1), 0, 0));
    }
    return WallFile.read(file, new DrawingSettings(unit, usualUnit, projection, frame, choice));
  }

  /** Prints the layers, classes, ids and colours of a drawing with the numbers of their shapes. */
  static void printLayers(Path file, Drawing drawing, PrintWriter terminal) {
    List<String> lines = drawing.labelLines();
    terminal.println(file + (lines.isEmpty() ? ": no layers, classes, ids or colours" : ""));
    lines.forEach(line -> terminal.println("  " + Place.printable(line)));
    drawing.leftOut().ifPresent(line -> terminal.println("  " + Place.printable(line)));
  }

  /** Describes the projection of degrees to metres in a line; empty if there was none. */
  static Optional<String> describeProjection(LocalProjection projection) {
    return Double.isNaN(projection.longitude())
        ? Optional.empty()
        : Optional.of(
            Texts.format(
                "projected to metres: equirectangular, WGS84, about latitude %s, longitude %s",
                projection.latitude(), projection.longitude()));
  }

  /** The scale and corner of drawings and pictures; empty if their scale is not given. */
  Optional<PictureFrame> frame() {
    if (scale != null && width != null) {
      throw new InputException("--scale and --width are given, expected one of them");
    }
    if (scale == null && width == null) {
      return Optional.empty();
    }
    PlanScale size =
        scale != null
            ? ScaleText.parse(scale)
            : new PlanScale.Width(RecordingOptions.positive("--width", width).getAsDouble());
    double[] corner =
        at == null ? new double[2] : Numbers.pair("--at", at, "two numbers, as -3.5,12");
    Ranges.within("--at", corner[0], -MAX_METRES, MAX_METRES);
    Ranges.within("--at", corner[1], -MAX_METRES, MAX_METRES);
    return Optional.of(new PictureFrame(size, corner[0], corner[1]));
  }

  /** The picture of the floor plan; empty if none is given. */
  Optional<Path> floorplan() {
    return floorplan;
  }

  /** The name of a picture in the folder of the scenario. */
  static String floorplanName(String scenario, Path picture) {
    String file = picture.getFileName().toString();
    int dot = file.lastIndexOf('.');
    return scenario + "-floorplan" + (dot < 0 ? "" : file.substring(dot));
  }

  /** Places a picture under the field. */
  Floorplan floorplan(String scenario, Path picture) {
    return new Floorplan(floorplanName(scenario, picture), area(picture));
  }

  /** The area that a picture shows. */
  Field area(Path picture) {
    return frame()
        .orElseThrow(
            () ->
                InputException.of(
                    "%s: a picture without --scale M, expected how many metres a pixel is, or"
                        + " --width M",
                    picture))
        .area(picture);
  }

  /** Sets the width of the plan, in metres, as if the user had asked for it. */
  void assumeWidth(double metres) {
    width = metres;
  }
}
