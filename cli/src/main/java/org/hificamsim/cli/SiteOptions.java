package org.hificamsim.cli;

import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import org.hificamsim.core.InputException;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.scenario.spec.Field;
import org.hificamsim.core.scenario.spec.Floorplan;
import org.hificamsim.tracks.SiteSettings;
import org.hificamsim.tracks.TrackedSite;
import org.hificamsim.tracks.format.Unit;
import org.hificamsim.tracks.ground.LocalProjection;
import org.hificamsim.tracks.place.PictureFrame;
import org.hificamsim.tracks.place.WallFile;
import picocli.CommandLine.Option;

/** The options for an imported scenario: name, field, walls, floor plan, cameras. */
final class SiteOptions {
  private static final double MAX_METRES = 1e9;
  private static final int MAX_CAMERAS = 1000;

  @Option(names = "--name", paramLabel = "NAME")
  private String name;

  @Option(names = "--cameras", paramLabel = "N")
  private int cameras;

  @Option(names = "--margin", paramLabel = "M")
  private Double margin;

  @Option(names = "--step", paramLabel = "S")
  private Double step;

  @Option(names = "--walls", paramLabel = "FILE")
  private Path walls;

  @Option(names = "--walls-unit", paramLabel = "U")
  private String wallsUnit;

  @Option(names = "--floorplan", paramLabel = "IMAGE")
  private Path floorplan;

  @Option(names = "--scale", paramLabel = "M")
  private Double scale;

  @Option(names = "--at", paramLabel = "X,Y")
  private String at;

  /** The name of the scenario: that of the option, else of the recording. */
  String name(Path recording) {
    String fileName = recording.getFileName().toString().replaceFirst("(?i)\\.gz$", "");
    String wanted = name != null ? name : fileName.replaceFirst("\\.[^.]*$", "");
    String safe = wanted.replaceAll("[^\\p{L}\\p{M}\\p{N}_.+-]", "-");
    if (safe.isEmpty() || safe.startsWith(".") || (name != null && !safe.equals(wanted))) {
      throw InputException.of(
          "--name is '%s', expected letters, digits and any of _.+- of them", wanted);
    }
    return safe;
  }

  /** The walls in metres; none if no file is given. */
  List<Obstacle> walls(Unit ofRecording, LocalProjection projection) {
    if (walls == null) {
      return List.of();
    }
    Unit defaultUnit = ofRecording == Unit.PX ? Unit.M : ofRecording;
    Unit unit = wallsUnit == null ? defaultUnit : RecordingOptions.unit("--walls-unit", wallsUnit);
    return WallFile.read(walls, unit, projection, frame());
  }

  private Optional<PictureFrame> frame() {
    OptionalDouble metres = RecordingOptions.positive("--scale", scale);
    if (metres.isEmpty()) {
      return Optional.empty();
    }
    double[] corner =
        at == null ? new double[2] : Numbers.pair("--at", at, "two numbers, as -3.5,12");
    Numbers.within("--at", corner[0], -MAX_METRES, MAX_METRES);
    Numbers.within("--at", corner[1], -MAX_METRES, MAX_METRES);
    return Optional.of(new PictureFrame(metres.getAsDouble(), corner[0], corner[1]));
  }

  /** The picture of the floor plan; null if none is given. */
  Path floorplan() {
    return floorplan;
  }

  /** The name of the picture in the folder of the scenario. */
  String floorplanName(String scenario) {
    String file = floorplan.getFileName().toString();
    int dot = file.lastIndexOf('.');
    return scenario + "-floorplan" + (dot < 0 ? "" : file.substring(dot));
  }

  SiteSettings settings(String scenario, Path recording, List<Obstacle> allWalls) {
    return new SiteSettings(
        scenario,
        recording,
        Numbers.inRange("--cameras", cameras, 1, MAX_CAMERAS),
        margin == null
            ? OptionalDouble.empty()
            : OptionalDouble.of(Numbers.within("--margin", margin, 0, MAX_METRES)),
        RecordingOptions.positive("--step", step),
        allWalls,
        floorplan == null ? Optional.empty() : Optional.of(plan(scenario)));
  }

  private Floorplan plan(String scenario) {
    PictureFrame frame =
        frame()
            .orElseThrow(
                () ->
                    new InputException(
                        "--floorplan without --scale M, expected how many metres a pixel is"));
    return new Floorplan(floorplanName(scenario), frame.area(floorplan));
  }

  /** The scenario in one line. */
  String line(TrackedSite made, List<Obstacle> allWalls) {
    Field field = made.field();
    return "field: %s x %s m; step: %s s; walls and solids: %s"
        .formatted(field.width(), field.height(), made.step(), allWalls.size());
  }
}
