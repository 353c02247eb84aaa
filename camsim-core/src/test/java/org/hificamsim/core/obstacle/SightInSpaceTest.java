package org.hificamsim.core.obstacle;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertFalse;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.util.ArrayList;
import java.util.List;
import java.util.Random;
import org.hificamsim.core.detection.Seen;
import org.junit.jupiter.api.Test;

/**
 * Compares sight in space with an independent ray caster: triangles from camera to body, clipped by
 * boxes, cylinders and upright rectangles in three dimensions.
 */
class SightInSpaceTest {
  private static final double EDGE = 1e-9;
  private static final int SCENES = 500;
  private static final int PAIRS = 200;

  /** Whether a solid, enlarged (or reduced) by a margin, meets the triangle from eye to body. */
  private interface Solid {
    boolean meets(double[] eye, double[] foot, double[] head, double margin);
  }

  private final Random random = new Random(38);

  private double randomBetween(double from, double to) {
    return from + random.nextDouble() * (to - from);
  }

  @Test
  void agreesWithRayCasterExceptNearEdges() {
    int hidden = 0;
    for (int scene = 0; scene < SCENES; scene++) {
      List<Obstacle> obstacles = new ArrayList<>();
      List<Solid> solids = new ArrayList<>();
      int count = 1 + random.nextInt(6);
      for (int i = 0; i < count; i++) {
        add(obstacles, solids);
      }
      for (int pair = 0; pair < PAIRS; pair++) {
        hidden += check(new Obstacles(obstacles), solids) ? 1 : 0;
      }
    }
    double share = hidden / (double) (SCENES * PAIRS);
    assertTrue(share > 0.2 && share < 0.8, "hidden: " + share);
  }

  private boolean check(Obstacles obstacles, List<Solid> solids) {
    double[] eye = {randomBetween(-10, 10), randomBetween(-10, 10), randomBetween(0, 8)};
    double height = randomBetween(0.5, 2.2);
    Seen seen = Seen.values()[random.nextInt(3)];
    double x = randomBetween(-10, 10);
    double y = randomBetween(-10, 10);
    double low = seen.low(height);
    double high = seen.high(height);
    double[] foot = {x, y, low};
    double[] head = {x, y, high};
    boolean blocked = solids.stream().anyMatch(solid -> solid.meets(eye, foot, head, -EDGE));
    boolean nearlyBlocked = solids.stream().anyMatch(solid -> solid.meets(eye, foot, head, EDGE));
    double light = obstacles.transmittance(eye[0], eye[1], eye[2], x, y, low, high);
    VisibleRegion region = VisibleRegion.of(obstacles, eye[0], eye[1]);
    assertEquals(light, region.transmittance(x, y, eye[2], low, high));
    assertTrue(light == 1 || nearlyBlocked, "hidden by nothing");
    assertFalse(light == 1 && blocked, "seen through something");
    return light == 0;
  }

  private void add(List<Obstacle> obstacles, List<Solid> solids) {
    double base = random.nextBoolean() ? 0 : randomBetween(0, 3);
    double top = random.nextInt(5) == 0 ? Double.POSITIVE_INFINITY : base + randomBetween(0.3, 4);
    double x = randomBetween(-8, 8);
    double y = randomBetween(-8, 8);
    double angle = randomBetween(0, Math.PI);
    double length = randomBetween(0.5, 5);
    switch (random.nextInt(3)) {
      case 0 -> {
        double dx = length * Math.cos(angle);
        double dy = length * Math.sin(angle);
        obstacles.add(new Obstacle.Wall(x - dx, y - dy, x + dx, y + dy, 0, base, top));
        solids.add(
            (eye, foot, head, margin) ->
                plane(
                    local(eye, x, y, angle),
                    local(foot, x, y, angle),
                    head[2],
                    length,
                    base,
                    top,
                    margin));
      }
      case 1 -> {
        double width = randomBetween(0.2, 3);
        obstacles.add(new Obstacle.Polygon(box(x, y, angle, length, width), 0, base, top));
        solids.add(
            (eye, foot, head, margin) ->
                clipped(
                    List.of(
                        local(eye, x, y, angle),
                        local(foot, x, y, angle),
                        local(head, x, y, angle)),
                    new double[] {length, width},
                    base,
                    top,
                    margin));
      }
      default -> {
        double radius = randomBetween(0.2, 2);
        obstacles.add(new Obstacle.Pillar(x, y, radius, 0, base, top));
        solids.add(
            (eye, foot, head, margin) ->
                cylinder(
                    eye, foot, head[2], new double[] {x, y, radius + margin}, base, top, margin));
      }
    }
  }

  private static List<Point> box(double x, double y, double angle, double length, double width) {
    List<Point> corners = new ArrayList<>();
    for (int[] sign : new int[][] {{-1, -1}, {1, -1}, {1, 1}, {-1, 1}}) {
      double along = sign[0] * length;
      double across = sign[1] * width;
      corners.add(
          new Point(
              x + along * Math.cos(angle) - across * Math.sin(angle),
              y + along * Math.sin(angle) + across * Math.cos(angle)));
    }
    return corners;
  }

  private static double[] local(double[] point, double x, double y, double angle) {
    double dx = point[0] - x;
    double dy = point[1] - y;
    return new double[] {
      dx * Math.cos(angle) + dy * Math.sin(angle),
      dy * Math.cos(angle) - dx * Math.sin(angle),
      point[2]
    };
  }

  /** Whether the triangle meets an upright rectangle along the first axis. */
  private static boolean plane(
      double[] eye,
      double[] foot,
      double head,
      double length,
      double base,
      double top,
      double margin) {
    if (eye[1] * foot[1] > 0) {
      return false;
    }
    double share = eye[1] / (eye[1] - foot[1]);
    double along = eye[0] + share * (foot[0] - eye[0]);
    double low = eye[2] + share * (foot[2] - eye[2]);
    double high = eye[2] + share * (head - eye[2]);
    return Math.abs(along) <= length + margin && low <= top + margin && high >= base - margin;
  }

  /** Clips a triangle by the sides of a box; returns whether anything is left. */
  private static boolean clipped(
      List<double[]> triangle, double[] half, double base, double top, double margin) {
    List<double[]> left = triangle;
    for (int axis = 0; axis < 2; axis++) {
      left = cut(left, axis, 1, half[axis] + margin);
      left = cut(left, axis, -1, half[axis] + margin);
    }
    left = Double.isInfinite(top) ? left : cut(left, 2, 1, top + margin);
    left = cut(left, 2, -1, -base + margin);
    return !left.isEmpty();
  }

  private static List<double[]> cut(List<double[]> polygon, int axis, int sign, double most) {
    List<double[]> left = new ArrayList<>();
    for (int i = 0; i < polygon.size(); i++) {
      double[] from = polygon.get(i);
      double[] to = polygon.get((i + 1) % polygon.size());
      double a = sign * from[axis] - most;
      double b = sign * to[axis] - most;
      if (a <= 0) {
        left.add(from);
      }
      if (a * b < 0) {
        double share = a / (a - b);
        double[] point = new double[3];
        for (int k = 0; k < 3; k++) {
          point[k] = from[k] + share * (to[k] - from[k]);
        }
        left.add(point);
      }
    }
    return left;
  }

  /**
   * Inside the circle, a convex function of the height must reach 0 for the triangle to meet it.
   */
  private static boolean cylinder(
      double[] eye,
      double[] foot,
      double head,
      double[] circle,
      double base,
      double top,
      double margin) {
    double dx = foot[0] - eye[0];
    double dy = foot[1] - eye[1];
    double fx = eye[0] - circle[0];
    double fy = eye[1] - circle[1];
    double a = dx * dx + dy * dy;
    double b = fx * dx + fy * dy;
    double root = b * b - a * (fx * fx + fy * fy - circle[2] * circle[2]);
    double from = Math.max(0, (-b - Math.sqrt(root)) / a);
    double to = Math.min(1, (-b + Math.sqrt(root)) / a);
    if (!(root >= 0) || from > to) {
      return false;
    }
    double least = Double.POSITIVE_INFINITY;
    double over = eye[2] - top - margin;
    double under = base - margin - eye[2];
    double fall = foot[2] - eye[2];
    double rise = head - eye[2];
    double crossing = (under - over) / (fall + rise);
    for (double t : new double[] {from, to, Math.max(from, Math.min(to, crossing))}) {
      least = Math.min(least, Math.max(over + t * fall, under - t * rise));
    }
    return least <= 0;
  }

  /** The shelf is 15 m away; similar triangles give the line from the camera to a head at 1.7 m. */
  @Test
  void seesOverShelfAsSimilarTrianglesDo() {
    assertTrue(isHeadSeen(1.8, 20), "3 - 1.3 * 15/20 = 2.025 is above 1.8");
    assertFalse(isHeadSeen(2.9, 20));
    double limit = 15 * (3 - 1.7) / (3 - 2.9); // 195 m: farther lines pass above 2.9 m
    assertFalse(isHeadSeen(2.9, limit - 1e-6));
    assertTrue(isHeadSeen(2.9, limit + 1e-6));
    assertTrue(isHeadSeen(2.9, 14.9), "before the shelf");
    double nearLimit = 15 * (3 - 1.7) / (3 - 1.8); // 16.25 m: nearer heads are hidden
    assertFalse(isHeadSeen(1.8, nearLimit - 1e-6));
    assertTrue(isHeadSeen(1.8, nearLimit + 1e-6));
  }

  private static boolean isHeadSeen(double shelf, double distance) {
    Obstacle wall = new Obstacle.Wall(15, -1, 15, 1, 0, 0, shelf);
    Obstacles obstacles = new Obstacles(List.of(wall));
    return VisibleRegion.of(obstacles, 0, 0).transmittance(distance, 0, 3, 1.7, 1.7) == 1;
  }

  @Test
  void targetsHideTargetsByTheirHeights() {
    double[] x = {5, 10};
    double[] y = {0, 0};
    double[] radius = {0.3, 0.3};
    double[] height = {1.9, 1.7};
    double line = 3 - 1.3 * 5.3 / 10; // height where the line leaves the nearer disc
    assertTrue(line > 1.9 && !hides(x, y, radius, height, 1.7, 1.7));
    assertTrue(hides(x, y, radius, height, 0, 1.7), "not all of it is seen");
    height[0] = line + 1e-9;
    assertTrue(hides(x, y, radius, height, 1.7, 1.7));
    assertFalse(TargetOcclusion.hidden(5, 0, 3, 1, x, y, radius, new double[] {1, 1.7}, 1.7, 1.7));
  }

  private static boolean hides(
      double[] x, double[] y, double[] radius, double[] height, double low, double high) {
    return TargetOcclusion.hidden(0, 0, 3, 1, x, y, radius, height, low, high);
  }
}
