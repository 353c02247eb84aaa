package org.hificamsim.network.agent;

import java.util.Arrays;
import java.util.stream.Stream;
import org.hificamsim.core.world.Targets;

/**
 * The stays of targets in the view of one camera, and their mean length by the direction in which
 * targets move (behaviour 8.7).
 *
 * <p>The direction depends on the first two positions of a stay, so no others are kept.
 */
final class ViewHistory {
  /** A target's stay in view. */
  private static final class Stay {
    private boolean seen;
    private int points;
    private double firstX;
    private double firstY;
    private double secondX;
    private double secondY;
    private int lastCategory;
  }

  private final Targets targets;
  private final HistoricalParameters parameters;

  /** The present stay of each target in the view. */
  private final Stay[] stays;

  /** The total length of finished stays, in steps, by category. */
  private final long[] staySums;

  /** The number of finished stays, by category. */
  private final long[] stayCounts;

  ViewHistory(Targets targets, HistoricalParameters parameters) {
    this.targets = targets;
    this.parameters = parameters;
    stays = Stream.generate(Stay::new).limit(targets.count()).toArray(Stay[]::new);
    staySums = new long[parameters.categories() + 1];
    stayCounts = new long[parameters.categories() + 1];
  }

  /** The category of a target's direction, from 1; 0 while unknown. */
  int category(int target) {
    return category(stays[target]);
  }

  private int category(Stay stay) {
    if (stay.points == 0) {
      return stay.lastCategory;
    }
    if (stay.points < 2) {
      return 0;
    }
    double direction = Math.atan2(stay.secondX - stay.firstX, stay.secondY - stay.firstY);
    double degrees = Math.toDegrees(direction) + 180;
    double width = 360.0 / parameters.categories();
    return degrees == 360 ? 1 : (int) Math.floor(degrees / width) + 1;
  }

  /**
   * Returns the value of a target, its visibility times a coefficient, and marks a visible target
   * as seen.
   */
  double value(int target, double visibility) {
    double value = parameters.history() ? visibility * coefficient(stays[target]) : visibility;
    stays[target].seen |= visibility > 0;
    return value;
  }

  private double coefficient(Stay stay) {
    double average = average(stay);
    if (Double.isNaN(average) || stay.points == 0) {
      return parameters.preInstantiation();
    }
    double left = average - stay.points;
    return left > 0 ? left : parameters.overstay();
  }

  /** The average length of a stay, in steps; NaN before the first stay has ended. */
  private double average(Stay stay) {
    if (!parameters.perCategory()) {
      long count = Arrays.stream(stayCounts).sum();
      return count == 0 ? Double.NaN : (double) Arrays.stream(staySums).sum() / count;
    }
    int category = category(stay);
    if (category == 0) {
      return 0.000001;
    }
    return stayCounts[category] == 0
        ? Double.NaN
        : (double) staySums[category] / stayCounts[category];
  }

  /** Ends the step: extends the stays of targets seen, and ends those of the others. */
  void endStep() {
    for (int target = 0; target < stays.length; target++) {
      Stay stay = stays[target];
      if (stay.seen) {
        grow(stay, targets.x(target), targets.y(target));
        stay.seen = false;
      } else if (stay.points > 0) {
        end(stay);
      }
    }
  }

  private static void grow(Stay stay, double x, double y) {
    if (stay.points == 0) {
      stay.lastCategory = 0;
      stay.firstX = x;
      stay.firstY = y;
    } else if (stay.points == 1) {
      stay.secondX = x;
      stay.secondY = y;
    }
    stay.points++;
  }

  private void end(Stay stay) {
    int category = parameters.classification() ? category(stay) : 0;
    if (category != 0 || !parameters.perCategory()) {
      staySums[category] += stay.points;
      stayCounts[category]++;
    }
    stay.points = 0;
    stay.lastCategory = category != 0 ? category : stay.lastCategory;
  }
}
