package org.hificamsim.tracks.mate;

import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;
import org.hificamsim.core.obstacle.Obstacle;
import org.hificamsim.core.obstacle.Obstacles;
import org.hificamsim.core.obstacle.VisibleRegion;
import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRow;

/**
 * A recorded episode of MATE (Pan et al., NeurIPS 2022): the poses of its cameras and targets, with
 * a row for each step with {@code c0_x, c0_y, c0_orientation, c0_viewing_angle, c0_sight_range,
 * ...} and {@code t0_x, t0_y, ...} in units and degrees, 0 is +x, counterclockwise. In the folder
 * of {@code NAME.csv} or {@code NAME.csv.gz} are its obstacles, {@code NAME.obstacles.csv} ({@code
 * x,y,radius}).
 *
 * @param steps the number of steps
 * @param cameras the number of cameras
 * @param targets the number of targets
 * @param coverage the expected mean share of the targets that a camera sees; in MATE a camera sees
 *     through an obstacle with probability {@link #TRANSMITTANCE}
 */
public record MateEpisode(int steps, int cameras, int targets, double coverage) {
  private static final double TRANSMITTANCE = 0.1;
  private static final double MAX_NUMBER = 1e9;
  private static final String EXPECTED_NUMBER = "a number from -1e9 to 1e9";
  private static final List<String> CAMERA_COLUMNS =
      List.of("x", "y", "orientation", "viewing_angle", "sight_range");

  /**
   * Replays an episode.
   *
   * @throws InputException if a file is missing or wrong
   */
  public static MateEpisode replay(Path file) {
    Obstacles obstacles = obstacles(file);
    try (CsvReader table =
        CsvReader.openCommaSeparated(file, "poses of a MATE episode: c0_x,...,t0_x,t0_y,...")) {
      List<String> columns = table.header(List.of("c0_x", "t0_x"));
      List<List<String>> cameras = names(columns, "c", CAMERA_COLUMNS);
      List<List<String>> targets = names(columns, "t", CAMERA_COLUMNS.subList(0, 2));
      VisibleRegion[] regions = new VisibleRegion[cameras.size()];
      double sum = 0;
      int steps = 0;
      for (CsvRow row = table.next(); row != null; row = table.next()) {
        sum += covered(row, cameras, targets, obstacles, regions);
        steps++;
      }
      if (steps == 0) {
        throw new Place(file.toString(), 1, 1)
            .error("the episode has no steps, expected one or more");
      }
      return new MateEpisode(steps, cameras.size(), targets.size(), sum / steps);
    }
  }

  private static Obstacles obstacles(Path file) {
    String name = file.getFileName().toString().replaceFirst("\\.csv(\\.gz)?$", "");
    Path obstacleFile = file.resolveSibling(name + ".obstacles.csv");
    List<Obstacle> discs = new ArrayList<>();
    try (CsvReader table =
        CsvReader.openCommaSeparated(obstacleFile, "obstacles of a MATE episode")) {
      table.header(List.of("x", "y", "radius"));
      table.forEachRow(
          row ->
              discs.add(
                  new Obstacle.Pillar(
                      number(row, "x"),
                      number(row, "y"),
                      row.number("radius", Double.MIN_NORMAL, MAX_NUMBER, "a number above 0"),
                      TRANSMITTANCE)));
    }
    return new Obstacles(discs);
  }

  /** The columns of each camera or target that the table has. */
  private static List<List<String>> names(
      List<String> columns, String kind, List<String> suffixes) {
    return Stream.iterate(0, number -> columns.contains(kind + number + "_x"), number -> number + 1)
        .map(number -> suffixes.stream().map(suffix -> kind + number + "_" + suffix).toList())
        .peek(
            names -> {
              if (!columns.containsAll(names)) {
                throw new InputException("the table lacks some of " + names + ", expected all");
              }
            })
        .toList();
  }

  private static double number(CsvRow row, String column) {
    return row.number(column, -MAX_NUMBER, MAX_NUMBER, EXPECTED_NUMBER);
  }

  /** The expected share of the targets that a camera sees in the step of a row. */
  private static double covered(
      CsvRow row,
      List<List<String>> cameras,
      List<List<String>> targets,
      Obstacles obstacles,
      VisibleRegion[] regions) {
    double[] missed = new double[targets.size()];
    Arrays.fill(missed, 1);
    for (int camera = 0; camera < regions.length; camera++) {
      double[] pose = cameras.get(camera).stream().mapToDouble(name -> number(row, name)).toArray();
      if (regions[camera] == null || !regions[camera].isFrom(pose[0], pose[1])) {
        regions[camera] = VisibleRegion.of(obstacles, pose[0], pose[1]);
      }
      for (int target = 0; target < missed.length; target++) {
        double x = number(row, targets.get(target).get(0));
        double y = number(row, targets.get(target).get(1));
        if (inView(pose, x - pose[0], y - pose[1])) {
          missed[target] *= 1 - regions[camera].transmittance(x, y);
        }
      }
    }
    return 1 - Arrays.stream(missed).average().orElse(1);
  }

  private static boolean inView(double[] pose, double dx, double dy) {
    double offAxis = Math.toDegrees(Math.atan2(dy, dx)) - pose[2];
    return Math.hypot(dx, dy) <= pose[4]
        && Math.abs(Math.IEEEremainder(offAxis, 360)) <= pose[3] / 2;
  }
}
