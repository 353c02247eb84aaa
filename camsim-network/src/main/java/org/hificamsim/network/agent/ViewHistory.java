package org.hificamsim.network.agent;

import java.util.Arrays;
import org.hificamsim.core.world.Targets;

/**
 * How long targets stay in one camera's view, by the direction in which they came (behaviour 8.7).
 *
 * <p>A direction needs only the first two positions of a stay: no others are kept.
 */
final class ViewHistory {
  private final Targets targets;
  private final HistoricalParameters parameters;
  private final boolean[] seen;
  private final int[] points;
  private final double[] firstX;
  private final double[] firstY;
  private final double[] secondX;
  private final double[] secondY;
  private final int[] lastCategory;
  private final long[] sums;
  private final long[] counts;

  ViewHistory(Targets targets, HistoricalParameters parameters) {
    this.targets = targets;
    this.parameters = parameters;
    int count = targets.count();
    seen = new boolean[count];
    points = new int[count];
    firstX = new double[count];
    firstY = new double[count];
    secondX = new double[count];
    secondY = new double[count];
    lastCategory = new int[count];
    sums = new long[parameters.categories() + 1];
    counts = new long[parameters.categories() + 1];
  }

  /** A target's direction, from 1; 0 while it is not known. */
  int category(int target) {
    if (points[target] == 0) {
      return lastCategory[target];
    }
    if (points[target] < 2) {
      return 0;
    }
    double degrees =
        Math.toDegrees(
                Math.atan2(secondX[target] - firstX[target], secondY[target] - firstY[target]))
            + 180;
    double width = 360.0 / parameters.categories();
    return degrees == 360 ? 1 : (int) Math.floor(degrees / width) + 1;
  }

  /**
   * What a target is worth: its visibility times a coefficient; a target in view counts as seen.
   */
  double value(int target, double visibility) {
    double value = parameters.history() ? visibility * coefficient(target) : visibility;
    if (visibility > 0) {
      seen[target] = true;
    }
    return value;
  }

  private double coefficient(int target) {
    double average = average(target);
    if (Double.isNaN(average) || points[target] == 0) {
      return parameters.preInstantiation();
    }
    double left = average - points[target];
    return left > 0 ? left : parameters.overstay();
  }

  /** NaN while there is none. */
  private double average(int target) {
    if (!parameters.perCategory()) {
      long count = Arrays.stream(counts).sum();
      return count == 0 ? Double.NaN : (double) Arrays.stream(sums).sum() / count;
    }
    int category = category(target);
    if (category == 0) {
      return 0.000001;
    }
    return counts[category] == 0 ? Double.NaN : (double) sums[category] / counts[category];
  }

  /** Ends the step: stays of targets seen grow, those of the others are over. */
  void endStep() {
    for (int target = 0; target < points.length; target++) {
      if (seen[target]) {
        grow(target);
        seen[target] = false;
      } else if (points[target] > 0) {
        end(target);
      }
    }
  }

  private void grow(int target) {
    if (points[target] == 0) {
      lastCategory[target] = 0;
      firstX[target] = targets.x(target);
      firstY[target] = targets.y(target);
    } else if (points[target] == 1) {
      secondX[target] = targets.x(target);
      secondY[target] = targets.y(target);
    }
    points[target]++;
  }

  private void end(int target) {
    int category = parameters.classification() ? category(target) : 0;
    if (category != 0 || !parameters.perCategory()) {
      sums[category] += points[target];
      counts[category]++;
    }
    points[target] = 0;
    lastCategory[target] = category != 0 ? category : lastCategory[target];
  }
}
