package org.hificamsim.profiling.lab;

import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.random.RandomGenerator;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Core;
import org.opencv.core.CvType;
import org.opencv.core.Mat;
import org.opencv.core.Scalar;
import org.opencv.core.Size;
import org.opencv.imgproc.Imgproc;

/**
 * The laboratory around the object: a far wall, and things that stand or hang at fixed positions in
 * front of it. All pictures show the same room; things in front of the object are left out.
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

  /** Creates a room with a number of things; with none, its wall is bare. */
  static Room create(PhotoSurfaces surfaces, int things, RandomGenerator random) {
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

  /** Creates a thing. Things with an even index hang on the wall, the others stand in the room. */
  private static Board thing(PhotoSurfaces surfaces, int index, RandomGenerator random) {
    Mat texture = surfaces.thingTexture(index, TEXTURE_SIDE, random);
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

  /** Returns the things behind an object at this distance (metres), the farthest first. */
  List<Board> behind(double distance) {
    return things.stream().filter(thing -> thing.distance() > distance + CLEARANCE).toList();
  }

  @Override
  public void close() {
    things.forEach(thing -> thing.texture().release());
  }

  /**
   * The far wall of the room: value noise in several octaves that is fixed to the wall, so that
   * zooming in shows finer detail.
   *
   * @param distance the distance of the wall, in metres
   * @param seed the seed of its pattern
   */
  record Backdrop(double distance, long seed) {
    private static final double COARSEST = 2.4;
    private static final int OCTAVES = 9;
    private static final double MAX_CELL = 32;

    /** Fills a canvas (32 bits, BGR, linear light) with what the camera sees of the bare wall. */
    void paint(Mat canvas, Pinhole camera) {
      canvas.setTo(new Scalar(0.30, 0.33, 0.36));
      double strength = 0.055;
      double cell = COARSEST;
      for (int octave = 0; octave < OCTAVES; octave++) {
        double pixels = cell * camera.magnification(distance);
        if (pixels >= 1.5) {
          add(canvas, pixels, strength, octave);
        }
        cell /= 2;
        strength *= 0.72;
      }
    }

    /**
     * Adds one octave. Large cells are drawn reduced, since warping is only exact to 1/32 pixel.
     */
    private void add(Mat canvas, double pixels, double strength, int octave) {
      double shrink = Math.min(1, MAX_CELL / pixels);
      Size size =
          new Size(Math.ceil(canvas.cols() * shrink) + 1, Math.ceil(canvas.rows() * shrink) + 1);
      double step = pixels * shrink;
      try (Mats mats = new Mats()) {
        int across = (int) Math.ceil(size.width / step / 2) + 2;
        int down = (int) Math.ceil(size.height / step / 2) + 2;
        Mat affine = mats.own(new Mat(2, 3, CvType.CV_64F));
        double left = size.width / 2 - across * step;
        double top = size.height / 2 - down * step;
        affine.put(0, 0, step, 0, left, 0, step, top);
        Mat small = mats.mat();
        Imgproc.warpAffine(
            lattice(mats, across, down, strength, octave),
            small,
            affine,
            size,
            Imgproc.INTER_CUBIC);
        Mat layer = mats.mat();
        Imgproc.resize(small, layer, canvas.size(), 0, 0, Imgproc.INTER_CUBIC);
        Mat colour = mats.mat();
        Imgproc.cvtColor(layer, colour, Imgproc.COLOR_GRAY2BGR);
        Core.add(canvas, colour, canvas);
      }
    }

    private Mat lattice(Mats mats, int across, int down, double strength, int octave) {
      float[] row = new float[2 * across + 1];
      Mat lattice = mats.own(new Mat(2 * down + 1, row.length, CvType.CV_32F));
      for (int y = -down; y <= down; y++) {
        for (int x = -across; x <= across; x++) {
          row[x + across] = (float) (strength * value(x, y, octave));
        }
        lattice.put(y + down, 0, row);
      }
      return lattice;
    }

    /** Returns the value of a lattice point in [-1, 1), a hash (SplitMix64's finalizer). */
    private double value(int x, int y, int octave) {
      long hash =
          seed + 0x9E3779B97F4A7C15L * (x * 73_856_093L ^ y * 19_349_663L ^ octave * 83_492_791L);
      hash = (hash ^ (hash >>> 30)) * 0xBF58476D1CE4E5B9L;
      hash = (hash ^ (hash >>> 27)) * 0x94D049BB133111EBL;
      return (hash ^ (hash >>> 31)) * 0x1p-63;
    }
  }
}
