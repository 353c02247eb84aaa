package org.hificamsim.core.obstacle;

import java.util.List;
import java.util.Optional;
import java.util.stream.IntStream;

/**
 * A set of obstacles that do not move, with tests of lines of sight. A line of sight is a closed
 * segment; whether it {@linkplain Obstacle#touches touches} an obstacle is decided exactly.
 */
public final class Obstacles {
  /** No obstacles. */
  public static final Obstacles NONE = new Obstacles(List.of());

  private final List<Obstacle> obstacles;
  private final Pieces pieces;

  /** Creates a set; transmittances are multiplied in the order of the list. */
  public Obstacles(List<Obstacle> obstacles) {
    this.obstacles = List.copyOf(obstacles);
    this.pieces = new Pieces(this.obstacles);
  }

  /** All obstacles, in the order given. */
  public List<Obstacle> all() {
    return obstacles;
  }

  /** Whether the set is empty. */
  public boolean isEmpty() {
    return obstacles.isEmpty();
  }

  /** The edges and pillars of the obstacles. */
  Pieces pieces() {
    return pieces;
  }

  /**
   * The part of the light that passes from one point to another, in [0, 1]: the product of the
   * transmittances of all obstacles that the segment touches; 1 if it touches none.
   */
  public double transmittance(double x1, double y1, double x2, double y2) {
    return transmittance(x1, y1, Double.NaN, x2, y2, 0, 0);
  }

  /**
   * The part of the light that passes in space from a point to an upright line between two heights;
   * each obstacle counts that any line of sight between the two touches.
   *
   * @param z the height of the first point, in metres; NaN in a flat world
   * @param low the lowest height of the upright line, in metres
   * @param high the greatest height of the upright line, in metres
   */
  public double transmittance(
      double x1, double y1, double z, double x2, double y2, double low, double high) {
    double product = 1;
    for (int i = 0; i < obstacles.size() && product > 0; i++) {
      Obstacle obstacle = obstacles.get(i);
      product *= obstacle.touches(x1, y1, z, x2, y2, low, high) ? obstacle.transmittance() : 1;
    }
    return product;
  }

  /** The obstacles that may meet a segment in a rectangle, of which opposite corners are given. */
  public Obstacles near(double x1, double y1, double x2, double y2) {
    return new Obstacles(
        IntStream.range(0, obstacles.size())
            .filter(i -> !pieces.isApart(i, x1, y1, x2, y2))
            .mapToObj(obstacles::get)
            .toList());
  }

  /** Whether a person can walk straight from one point to the other. */
  public boolean clear(double x1, double y1, double x2, double y2) {
    for (int i = 0; i < obstacles.size(); i++) {
      if (!pieces.isApart(i, x1, y1, x2, y2)
          && obstacles.get(i).standing()
          && obstacles.get(i).touches(x1, y1, x2, y2)) {
        return false;
      }
    }
    return true;
  }

  @Override
  public boolean equals(Object other) {
    return other instanceof Obstacles that && obstacles.equals(that.obstacles);
  }

  @Override
  public int hashCode() {
    return obstacles.hashCode();
  }

  @Override
  public String toString() {
    return obstacles.toString();
  }

  /** The first obstacle to people that contains a position. */
  public Optional<Obstacle> containing(double x, double y) {
    return obstacles.stream()
        .filter(obstacle -> obstacle.standing() && obstacle.contains(x, y))
        .findFirst();
  }

  /** The first solid obstacle that contains a point in space. */
  public Optional<Obstacle> containing(double x, double y, double z) {
    return obstacles.stream()
        .filter(Obstacle::solid)
        .filter(obstacle -> z >= obstacle.base() && z <= obstacle.height())
        .filter(obstacle -> obstacle.contains(x, y))
        .findFirst();
  }
}
