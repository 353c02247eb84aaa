package org.hificamsim.core.silhouette;

/**
 * A target as a camera sees it: an upright rectangle that faces the camera, and what stands in
 * front of it. Everything is projected through the camera onto the plane of the rectangle, so that
 * nearer targets are rectangles there, and walls are strips under straight lines. In a flat world
 * everything has the full height.
 *
 * <p>Reuse one for many targets. Not thread-safe.
 */
final class Silhouette {
  /** The share of the distance to the target that is too close to the camera to be projected. */
  private static final double TOO_CLOSE = 1e-9;

  private final CoveredShare covered = new CoveredShare();
  private double cameraX;
  private double cameraY;
  private double cameraZ;
  private boolean flat;
  private double distance;
  private double aheadX;
  private double aheadY;
  private double half;
  private double feet;
  private double rise;

  /** Stands at a camera; z is NaN in a flat world. */
  void standAt(double x, double y, double z) {
    cameraX = x;
    cameraY = y;
    cameraZ = z;
    flat = Double.isNaN(z);
  }

  /** Looks at a target, with nothing in front of it yet; all in metres. */
  void lookAt(double x, double y, double width, double height) {
    covered.clear();
    distance = Math.sqrt((x - cameraX) * (x - cameraX) + (y - cameraY) * (y - cameraY));
    aheadX = (x - cameraX) / distance;
    aheadY = (y - cameraY) / distance;
    half = width / 2 / distance;
    feet = -cameraZ / distance;
    rise = height / distance;
  }

  /** The distance to the target over the ground, in metres. */
  double distance() {
    return distance;
  }

  /** Returns half of the angle that the target fills, in radians, rounded up. */
  double halfAngle() {
    return half;
  }

  /** An upper bound of the distance over the ground to its ends, in metres. */
  double farthest() {
    return distance * (1 + half * half);
  }

  /**
   * Puts another target in front, unless it is farther away or contains the camera.
   *
   * @param dx its distance from the camera along x, in metres
   * @param dy its distance from the camera along y, in metres
   */
  void addTarget(double dx, double dy, double width, double height) {
    double squared = dx * dx + dy * dy;
    double depth = dx * aheadX + dy * aheadY;
    if (squared < distance * distance
        && depth > TOO_CLOSE * distance
        && squared > width * width / 4) {
      addRectangle(dx * aheadY - dy * aheadX, width / 2, depth, height);
    }
  }

  /** Adds a nearer target, whose feet are lower in the picture than the silhouette's. */
  private void addRectangle(double aside, double halfWidth, double depth, double height) {
    double reach = half * depth;
    if (aside - halfWidth < reach && aside + halfWidth > -reach) {
      covered.add(
          squareX((aside - halfWidth) / depth),
          0,
          squareX((aside + halfWidth) / depth),
          flat ? 1 : squareY(height, depth));
    }
  }

  /** Puts a piece of an obstacle in front, as far as it is nearer than the target. */
  void addWall(Walls walls, int piece) {
    if (walls.radius(piece) > 0) {
      addPillar(walls, piece);
    } else {
      addEdge(walls, piece);
    }
  }

  /**
   * Adds the shadow of a pillar, as wide as the pillar's part before the target and as high as its
   * middle.
   */
  private void addPillar(Walls walls, int piece) {
    double depth = depth(walls.x1(piece), walls.y1(piece));
    double aside = aside(walls.x1(piece), walls.y1(piece));
    double radius = walls.radius(piece);
    double away = Math.hypot(depth, aside);
    if (away > radius && depth + radius > 0 && depth - radius < distance) {
      double middle = Math.max(TOO_CLOSE * distance, Math.min(depth, distance));
      covered.add(
          squareX(edge(depth, aside, radius, -1)),
          flat ? 0 : squareY(walls.base(piece), middle),
          squareX(edge(depth, aside, radius, 1)),
          flat ? 1 : squareY(walls.height(piece), middle));
    }
  }

  /**
   * The tangent of the direction in which a pillar ends on one side: where it is touched, or, if
   * that is behind the target, where it meets the target's plane.
   */
  private double edge(double depth, double aside, double radius, int side) {
    double away = Math.hypot(depth, aside);
    double direction = Math.atan2(aside, depth) + side * Math.asin(radius / away);
    double touched = Math.sqrt(away * away - radius * radius) * Math.cos(direction);
    if (touched > distance) {
      double behind = distance - depth;
      return (aside + side * Math.sqrt(Math.max(0, radius * radius - behind * behind))) / distance;
    }
    return Math.abs(direction) < Math.PI / 2
        ? Math.tan(direction)
        : Math.copySign(Double.POSITIVE_INFINITY, direction);
  }

  private void addEdge(Walls walls, int piece) {
    double depth1 = depth(walls.x1(piece), walls.y1(piece));
    double depth2 = depth(walls.x2(piece), walls.y2(piece));
    double aside1 = aside(walls.x1(piece), walls.y1(piece));
    double aside2 = aside(walls.x2(piece), walls.y2(piece));
    double from = entry(depth1, depth2);
    double to = 1 - entry(depth2, depth1);
    if (from < to) {
      double nearDepth = depth1 + from * (depth2 - depth1);
      double farDepth = depth1 + to * (depth2 - depth1);
      double first = squareX((aside1 + from * (aside2 - aside1)) / nearDepth);
      double second = squareX((aside1 + to * (aside2 - aside1)) / farDepth);
      if (first < second) {
        addStrip(first, nearDepth, second, farDepth, walls.base(piece), walls.height(piece));
      } else if (second < first) {
        addStrip(second, farDepth, first, nearDepth, walls.base(piece), walls.height(piece));
      }
    }
  }

  /** The share of the way from one depth to the other at which it is between camera and target. */
  private double entry(double depth1, double depth2) {
    double near = TOO_CLOSE * distance;
    if (depth1 < near) {
      return depth2 > near ? (near - depth1) / (depth2 - depth1) : 1;
    }
    return depth1 <= distance ? 0 : depth2 < distance ? (depth1 - distance) / (depth1 - depth2) : 1;
  }

  private void addStrip(
      double left, double leftDepth, double right, double rightDepth, double base, double height) {
    if (flat) {
      covered.add(left, 0, right, 1);
      return;
    }
    double lowSlope = slope(left, squareY(base, leftDepth), right, squareY(base, rightDepth));
    double highSlope = slope(left, squareY(height, leftDepth), right, squareY(height, rightDepth));
    covered.add(
        left,
        right,
        squareY(base, leftDepth) - lowSlope * left,
        lowSlope,
        squareY(height, leftDepth) - highSlope * left,
        highSlope);
  }

  private static double slope(double left, double atLeft, double right, double atRight) {
    double slope = (atRight - atLeft) / (right - left);
    return Double.isNaN(slope) || atLeft == atRight ? 0 : slope;
  }

  private double depth(double x, double y) {
    return (x - cameraX) * aheadX + (y - cameraY) * aheadY;
  }

  private double aside(double x, double y) {
    return (x - cameraX) * aheadY - (y - cameraY) * aheadX;
  }

  /** Maps a tangent off the line to the target to the unit square. */
  private double squareX(double tangent) {
    return (tangent + half) / (2 * half);
  }

  /** Maps a height at a depth to the unit square. */
  private double squareY(double height, double depth) {
    return ((height - cameraZ) / depth - feet) / rise;
  }

  /** Whether nothing of the target is left to hide. */
  boolean hidden() {
    return covered.full();
  }

  /** The share of the target that is hidden, in [0, 1]. */
  double share() {
    return covered.share();
  }
}
