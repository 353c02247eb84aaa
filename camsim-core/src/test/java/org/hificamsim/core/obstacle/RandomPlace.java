package org.hificamsim.core.obstacle;

import java.util.ArrayList;
import java.util.List;
import java.util.Optional;
import java.util.SplittableRandom;
import java.util.stream.IntStream;
import java.util.stream.Stream;

/** Random obstacles and points, mostly on a lattice, so that lines touch and run along others. */
final class RandomPlace {
  /** The smallest offset from 0; JTS loses smaller ones. */
  private static final double TINY = 1e-30;

  private final SplittableRandom random;
  private final int lattice;
  private final double scale;

  /**
   * Chooses by the seed whether coordinates are integers, any doubles, tenths, or tenths far from
   * the origin, as on a map.
   */
  RandomPlace(long seed) {
    this(seed, 4, 0);
  }

  private RandomPlace(long seed, int lattices, int mostDoublings) {
    random = new SplittableRandom(seed);
    lattice = random.nextInt(lattices);
    scale = Math.scalb(1.0, random.nextInt(-mostDoublings, mostDoublings + 1));
  }

  /** Creates a place of a size between 1e-90 and 1e90 metres. */
  static RandomPlace ofAnySize(long seed) {
    return new RandomPlace(seed, 4, 300);
  }

  /**
   * Creates a place without tenths: JTS computes with 106 bits, too few to distinguish a point that
   * is 1e-33 off a line.
   */
  static RandomPlace forJts(long seed) {
    return new RandomPlace(seed, 2, 0);
  }

  double coordinate() {
    return scale * unscaled();
  }

  private double unscaled() {
    return switch (lattice) {
      case 0 -> random.nextInt(-6, 7);
      case 1 -> random.nextDouble(-6, 6);
      case 2 -> random.nextInt(-30, 31) / 10.0;
      default -> random.nextInt(5_800_000, 5_800_061) / 10.0;
    };
  }

  Point point() {
    return new Point(coordinate(), coordinate());
  }

  private double transmittance(boolean solid) {
    return solid || random.nextInt(3) > 0 ? 0 : random.nextInt(1, 10) / 10.0;
  }

  /** Returns a new point, or sometimes an earlier one, so that obstacles share ends. */
  private Point point(List<Point> taken) {
    boolean again = !taken.isEmpty() && random.nextInt(4) == 0;
    Point point = again ? taken.get(random.nextInt(taken.size())) : point();
    taken.add(point);
    return point;
  }

  Obstacles obstacles(int most, boolean solid) {
    List<Point> taken = new ArrayList<>();
    int count = random.nextInt(most + 1);
    return new Obstacles(Stream.generate(() -> obstacle(taken, solid)).limit(count).toList());
  }

  private Obstacle obstacle(List<Point> taken, boolean solid) {
    Optional<Obstacle> made = Optional.empty();
    while (made.isEmpty()) {
      made =
          switch (random.nextInt(3)) {
            case 0 -> wall(point(taken), point(taken), solid);
            case 1 -> polygon(taken, solid);
            default -> Optional.of(pillar(solid));
          };
    }
    return made.get();
  }

  private Optional<Obstacle> wall(Point from, Point to, boolean solid) {
    return from.equals(to)
        ? Optional.empty()
        : Optional.of(new Obstacle.Wall(from.x(), from.y(), to.x(), to.y(), transmittance(solid)));
  }

  Obstacle.Pillar pillar(boolean solid) {
    double radius = lattice == 1 ? random.nextDouble(0.1, 2) : random.nextInt(1, 11) / 2.0;
    return new Obstacle.Pillar(
        coordinate(), coordinate(), scale * radius / 2, transmittance(solid));
  }

  private Optional<Obstacle> polygon(List<Point> taken, boolean solid) {
    int corners = random.nextInt(3, 7);
    List<Point> points = IntStream.range(0, corners).mapToObj(i -> point(taken)).toList();
    try {
      return Optional.of(new Obstacle.Polygon(points, transmittance(solid)));
    } catch (IllegalArgumentException notSimple) {
      return Optional.empty();
    }
  }

  /** Returns a point anywhere, on a border, or in line with a standpoint and a corner. */
  Point target(Obstacles obstacles, Point standpoint) {
    Point point = point();
    if (obstacles.isEmpty() || random.nextInt(3) == 0) {
      return point;
    }
    Pieces pieces = obstacles.pieces();
    int piece = random.nextInt(pieces.count());
    Point from = new Point(pieces.x1[piece], pieces.y1[piece]);
    Point to =
        pieces.radius[piece] > 0
            ? new Point(from.x() + pieces.radius[piece], from.y())
            : new Point(pieces.x2[piece], pieces.y2[piece]);
    return switch (random.nextInt(4)) {
      case 0 -> to;
      case 1 -> new Point((from.x() + to.x()) / 2, (from.y() + to.y()) / 2);
      case 2 -> new Point(2 * to.x() - standpoint.x(), 2 * to.y() - standpoint.y());
      default -> new Point(to.x(), to.y() + Math.max(TINY, Math.ulp(to.y())));
    };
  }
}
