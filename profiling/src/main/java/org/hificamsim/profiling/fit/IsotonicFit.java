package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.hificamsim.hifi.detector.IsotonicCurve;

/**
 * Isotonic regression: the rising steps with the least squared error, by pooling adjacent violators
 * (Ayer et al. 1955); straight in between.
 */
final class IsotonicFit {
  private IsotonicFit() {}

  /** Rows side by side that have one mean. */
  private record Block(double from, double to, double sum, int rows) {
    double mean() {
      return sum / rows;
    }

    Block and(Block next) {
      return new Block(from, next.to, sum + next.sum, rows + next.rows);
    }
  }

  /** The curve through the means of the pooled rows. */
  static IsotonicCurve fit(double[] pip, double[] confidence) {
    List<Block> pooled = new ArrayList<>();
    for (Block block : sorted(pip, confidence)) {
      Block last = block;
      while (!pooled.isEmpty() && pooled.get(pooled.size() - 1).mean() >= last.mean()) {
        last = pooled.remove(pooled.size() - 1).and(last);
      }
      pooled.add(last);
    }
    return new IsotonicCurve(knots(pooled));
  }

  /** One block for each PIP, in order. */
  private static Collection<Block> sorted(double[] pip, double[] confidence) {
    Map<Double, Block> blocks = new TreeMap<>();
    for (int i = 0; i < pip.length; i++) {
      blocks.merge(pip[i], new Block(pip[i], pip[i], confidence[i], 1), Block::and);
    }
    return blocks.values();
  }

  private static double[][] knots(List<Block> blocks) {
    List<double[]> knots = new ArrayList<>();
    for (Block block : blocks) {
      knots.add(new double[] {block.from(), block.mean()});
      if (block.to() > block.from()) {
        knots.add(new double[] {block.to(), block.mean()});
      }
    }
    return knots.toArray(double[][]::new);
  }
}
