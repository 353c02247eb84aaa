package org.hificamsim.profiling.fit;

import java.util.ArrayList;
import java.util.Collection;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import org.hificamsim.hifi.detector.IsotonicCurve;

/**
 * Isotonic regression: fits non-decreasing steps with the least squared error by pooling adjacent
 * violators (Ayer et al. 1955), and connects them by lines.
 */
final class IsotonicFit {
  private IsotonicFit() {}

  /** Adjacent rows that are replaced by their mean. */
  private record Block(double from, double to, double sum, int rows) {
    double mean() {
      return sum / rows;
    }

    Block merge(Block next) {
      return new Block(from, next.to, sum + next.sum, rows + next.rows);
    }
  }

  /** Returns the curve through the means of the pooled rows. */
  static IsotonicCurve fit(double[] pip, double[] confidence) {
    List<Block> pooled = new ArrayList<>();
    for (Block block : sorted(pip, confidence)) {
      Block last = block;
      while (!pooled.isEmpty() && pooled.get(pooled.size() - 1).mean() >= last.mean()) {
        last = pooled.remove(pooled.size() - 1).merge(last);
      }
      pooled.add(last);
    }
    return new IsotonicCurve(knots(pooled));
  }

  /** Returns one block for each PIP, in order. */
  private static Collection<Block> sorted(double[] pip, double[] confidence) {
    Map<Double, Block> blocks = new TreeMap<>();
    for (int i = 0; i < pip.length; i++) {
      blocks.merge(pip[i], new Block(pip[i], pip[i], confidence[i], 1), Block::merge);
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
