package org.hificamsim.core.obstacle;

import java.util.List;
import java.util.Optional;

/**
 * Obstacles that do not move, and what a line of sight meets of them. A line of sight is a closed
 * segment, with both its ends. It is decided exactly whether it {@linkplain Obstacle#touches
 * touches} an obstacle, by the doubles as they are.
 */
public final class Obstacles {
  /** None. */
  public static final Obstacles NONE = new Obstacles(List.of());

  private final List<Obstacle> obstacles;
  private final Pieces pieces;

  /** Copies the list; transmittances are multiplied in its order. */
  public Obstacles(List<Obstacle> obstacles) {
    this.obstacles = List.copyOf(obstacles);
    this.pieces = new Pieces(this.obstacles);
  }

  /** In the order given. */
  public List<Obstacle> all() {
    return obstacles;
  }

  /** Whether there are none. */
  public boolean isEmpty() {
    return obstacles.isEmpty();
  }

  /** What they are made of. */
  Pieces pieces() {
    return pieces;
  }

  /**
   * The part of the light that passes from one point to another, in [0, 1]: the product of the
   * transmittances of all obstacles touched, each once; 1 where none is.
   */
  public double transmittance(double x1, double y1, double x2, double y2) {
    return transmittance(x1, y1, Double.NaN, x2, y2, 0, 0);
  }

  /**
   * The same in space: from a point at a height to what is between two heights of an upright line;
   * an obstacle that any of these lines touches counts.
   *
   * @param z the height of the first point, metres; NaN in a flat world
   * @param low the least height of what is looked at, metres
   * @param high the greatest, metres
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

  /** Whether one may walk straight: no solid obstacle that stands on the ground is touched. */
  public boolean clear(double x1, double y1, double x2, double y2) {
    for (int i = 0; i < obstacles.size(); i++) {
      if (!pieces.apart(i, x1, y1, x2, y2)
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

  /** The first solid obstacle on the ground that a place is inside or on the border of. */
  public Optional<Obstacle> containing(double x, double y) {
    return obstacles.stream().filter(o -> o.standing() && o.contains(x, y)).findFirst();
  }

  /** The first solid obstacle that a point in space is inside or on the border of. */
  public Optional<Obstacle> containing(double x, double y, double z) {
    return obstacles.stream()
        .filter(o -> o.solid() && z >= o.base() && z <= o.height() && o.contains(x, y))
        .findFirst();
  }
}
