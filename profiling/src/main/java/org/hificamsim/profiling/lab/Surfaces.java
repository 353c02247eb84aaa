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
}
