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

/** Settings of an imported scenario: name, field, walls, floor plan, cameras. */
final class SiteOptions {
  private static final double LARGE = 1e9;
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

  /** The scenario's name. */
  String name(Path recording) {
    String plain = recording.getFileName().toString().replaceFirst("(?i)\\.gz$", "");
    String own = name != null ? name : plain.replaceFirst("\\.[^.]*$", "");
    String safe = own.replaceAll("[^\\p{L}\\p{M}\\p{N}_.+-]", "-");
    if (safe.isEmpty() || safe.startsWith(".") || (name != null && !safe.equals(own))) {
      throw InputException.of(
          "--name is '%s', expected letters, digits and any of _.+- of them", own);
    }
    return safe;
  }

  /** The walls in metres; none where no file is given. */
  List<Obstacle> walls(Unit ofRecording, LocalProjection projection) {
    if (walls == null) {
      return List.of();
    }
    Unit unit = ofRecording == Unit.PX ? Unit.M : ofRecording;
    Unit own = wallsUnit == null ? unit : RecordingOptions.unit("--walls-unit", wallsUnit);
    return WallFile.read(walls, own, projection, frame());
  }

  private Optional<PictureFrame> frame() {
    OptionalDouble metres = RecordingOptions.positive("--scale", scale);
    if (metres.isEmpty()) {
      return Optional.empty();
    }
    double[] corner =
        at == null ? new double[2] : Numbers.pair("--at", at, "two numbers, as -3.5,12");
    Numbers.within("--at", corner[0], -LARGE, LARGE);
    Numbers.within("--at", corner[1], -LARGE, LARGE);
    return Optional.of(new PictureFrame(metres.getAsDouble(), corner[0], corner[1]));
  }

  /** The picture; null where none is given. */
  Path floorplan() {
    return floorplan;
  }

  /** Its name in the scenario's folder. */
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
            : OptionalDouble.of(Numbers.within("--margin", margin, 0, LARGE)),
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

  /** What was made, in a line. */
  String line(TrackedSite made, List<Obstacle> allWalls) {
    Field field = made.field();
    return "field: %s x %s m; step: %s s; walls and solids: %s"
        .formatted(field.width(), field.height(), made.step(), allWalls.size());
  }
}
