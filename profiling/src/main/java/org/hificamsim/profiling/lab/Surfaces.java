package org.hificamsim.profiling.lab;

import java.util.List;
import java.util.random.RandomGenerator;
import org.opencv.core.Mat;

/** Where the textures come from: square, 8 bits, BGR. */
interface Surfaces extends AutoCloseable {
  /** What is on an object; the caller releases it. */
  Mat target(LabObject object, int side, RandomGenerator random);

  /** What is on a thing in the room; the caller releases it. */
  Mat thing(int index, int side, RandomGenerator random);

  /** What covers the far wall, at this distance (metres). */
  List<Board> wall(double distance, RandomGenerator random);

  @Override
  void close();

  /** Random shapes, words and grain; the wall stays bare. */
  record Painted() implements Surfaces {
    @Override
    public Mat target(LabObject object, int side, RandomGenerator random) {
      return TexturePainter.paint(object.pattern(), side, random);
    }

    @Override
    public Mat thing(int index, int side, RandomGenerator random) {
      return TexturePainter.paint(Pattern.ALL.get(index % Pattern.ALL.size()), side, random);
    }

    @Override
    public List<Board> wall(double distance, RandomGenerator random) {
      return List.of();
    }

    @Override
    public void close() {}
  }
}
