package org.hificamsim.profiling.lab;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.random.RandomGenerator;
import org.opencv.core.Mat;

/**
 * The laboratory around the object: a far wall, and things that stand or hang at fixed places in
 * front of it. The same room serves every picture; what stands in front of the object is out of the
 * way.
 */
final class Room implements AutoCloseable {
  private static final double WALL = 12;
  private static final double CLEARANCE = 0.3;
  private static final double TANGENT_OF_WIDEST_VIEW = 0.9;
  private static final int TEXTURE_SIDE = 512;

  private final Backdrop wall;
  private final List<Board> things;

  private Room(Backdrop wall, List<Board> things) {
    this.wall = wall;
    this.things = things;
  }

  /** A room with this many things; without any, its wall is bare. */
  static Room furnished(PhotoSurfaces surfaces, int things, RandomGenerator random) {
    Backdrop wall = new Backdrop(WALL, random.nextLong());
    List<Board> boards = new ArrayList<>();
    for (int i = 0; i < things; i++) {
      boards.add(thing(surfaces, i, random));
    }
    if (things > 0) {
      boards.addAll(surfaces.wall(WALL, random));
    }
    boards.sort(Comparator.comparingDouble(Board::distance).reversed());
    return new Room(wall, boards);
  }

  /** Every other thing hangs on the wall; the rest stand about, off the middle. */
  private static Board thing(PhotoSurfaces surfaces, int index, RandomGenerator random) {
    Mat texture = surfaces.thing(index, TEXTURE_SIDE, random);
    boolean hangs = index % 2 == 0;
    double distance = hangs ? WALL - 0.05 : random.nextDouble(2, WALL - 0.5);
    double reach = distance * TANGENT_OF_WIDEST_VIEW;
    double spread = random.nextDouble() * (index % 3 == 0 ? 1 : random.nextDouble());
    double side = (random.nextBoolean() ? 1 : -1) * reach * (0.06 + spread);
    double width = random.nextDouble(0.3, hangs ? 1.4 : 0.9);
    double height = width * random.nextDouble(0.6, 1.5);
    double down = hangs ? random.nextDouble(-2.2, 1.8) : random.nextDouble(-0.6, 1.2);
    return new Board(texture, false, width, height, side, down, distance, Board.Pose.FRONTAL);
  }

  Backdrop wall() {
    return wall;
  }

  double wallDistance() {
    return WALL;
  }

  /** What stands behind an object at this distance (metres), the farthest first. */
  List<Board> behind(double distance) {
    return things.stream().filter(thing -> thing.distance() > distance + CLEARANCE).toList();
  }

  @Override
  public void close() {
    things.forEach(thing -> thing.texture().release());
  }
}
