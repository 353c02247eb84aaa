package org.hificamsim.profiling.lab;

import java.util.List;
import java.util.random.RandomGenerator;
import org.opencv.core.Mat;

/** Random shapes, words and grain; the wall stays bare. */
final class PaintedSurfaces implements Surfaces {
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
