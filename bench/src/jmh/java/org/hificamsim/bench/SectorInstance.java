package org.hificamsim.bench;

import java.awt.geom.Line2D;
import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.SplittableRandom;

/**
 * One step of a world with optics and walls, as a coverage problem. There are 14 cameras on the
 * border of a field of 30 m by 20 m, each with five headings and five angles of view, 8 targets and
 * 2 walls. A view is 640 pixels wide and reaches to the distance at which a metre has 62.5 pixels,
 * so that narrower views reach farther.
 */
final class SectorInstance {
  private static final double WIDTH = 30;
  private static final double HEIGHT = 20;
  private static final int CAMERAS = 14;
  private static final int TARGETS = 8;
  private static final double[] HEADINGS = {-60, -30, 0, 30, 60};
  private static final double[] OPENINGS = {58, 40, 25, 15, 8};
  private static final double PIXELS = 640;
  private static final double PIXELS_PER_METRE = 62.5;

  private final SplittableRandom random;
  private final double[][] targets = new double[TARGETS][];
  private final Line2D[] walls = new Line2D[2];

  private SectorInstance(long seed) {
    random = new SplittableRandom(seed);
    for (int target = 0; target < TARGETS; target++) {
      targets[target] = randomPosition();
    }
    for (int wall = 0; wall < walls.length; wall++) {
      double[] from = randomPosition();
      double angle = random.nextDouble(Math.PI);
      walls[wall] =
          new Line2D.Double(
              from[0], from[1], from[0] + 6 * Math.cos(angle), from[1] + 6 * Math.sin(angle));
    }
  }

  /**
   * Writes instances as {@code step_instances.py} does.
   *
   * @param args the file, and the number of instances
   */
  public static void main(String[] args) throws IOException {
    List<String> lines = new ArrayList<>();
    for (int seed = 0; seed < Integer.parseInt(args[1]); seed++) {
      lines.add(new SectorInstance(seed).instance().json());
    }
    Files.createDirectories(Path.of(args[0]).toAbsolutePath().getParent());
    Files.write(Path.of(args[0]), lines);
  }

  private double[] randomPosition() {
    return new double[] {random.nextDouble(WIDTH), random.nextDouble(HEIGHT)};
  }

  private OptimumInstance instance() {
    long[][] sets = new long[CAMERAS][HEADINGS.length * OPENINGS.length];
    for (int camera = 0; camera < CAMERAS; camera++) {
      double[] position = onBorder((camera + 0.5) / CAMERAS * 2 * (WIDTH + HEIGHT));
      for (int view = 0; view < sets[camera].length; view++) {
        sets[camera][view] = seen(position, view);
      }
    }
    return new OptimumInstance(TARGETS, sets);
  }

  private static double[] onBorder(double along) {
    if (along < WIDTH) {
      return new double[] {along, 0};
    } else if (along < WIDTH + HEIGHT) {
      return new double[] {WIDTH, along - WIDTH};
    } else if (along < 2 * WIDTH + HEIGHT) {
      return new double[] {2 * WIDTH + HEIGHT - along, HEIGHT};
    }
    return new double[] {0, 2 * (WIDTH + HEIGHT) - along};
  }

  private long seen(double[] camera, int view) {
    double inwards = Math.atan2(HEIGHT / 2 - camera[1], WIDTH / 2 - camera[0]);
    double axis = inwards + Math.toRadians(HEADINGS[view / OPENINGS.length]);
    double opening = Math.toRadians(OPENINGS[view % OPENINGS.length]);
    double reach = PIXELS / (2 * PIXELS_PER_METRE * Math.tan(opening / 2));
    long seen = 0;
    for (int target = 0; target < TARGETS; target++) {
      double x = targets[target][0] - camera[0];
      double y = targets[target][1] - camera[1];
      double off = Math.abs(Math.IEEEremainder(Math.atan2(y, x) - axis, 2 * Math.PI));
      if (Math.hypot(x, y) <= reach && off <= opening / 2 && !hidden(camera, targets[target])) {
        seen |= 1L << target;
      }
    }
    return seen;
  }

  private boolean hidden(double[] camera, double[] target) {
    boolean hidden = false;
    for (Line2D wall : walls) {
      hidden |= wall.intersectsLine(camera[0], camera[1], target[0], target[1]);
    }
    return hidden;
  }
}
