package org.hificamsim.agents.cooperative;

import java.util.Arrays;

/**
 * Targets that were seen lately: where each one is now, as far as is known, and how it moves. While
 * nobody sees them they go on as they went, up to the next obstacle.
 */
final class TargetTracks {
  private static final double FEW = 0.05; // what is left of a track that is given up

  private final Parameters parameters;
  private final SiteSight sight;
  private boolean[] known = {};
  private int[] list = {}; // of those that are known
  private int count;
  private double[] x = {};
  private double[] y = {};
  private double[] wayX = {}; // of a step
  private double[] wayY = {};
  private double[] seenX = {};
  private double[] seenY = {};
  private long[] seenAt = {}; // step
  private double[] size = {};
  private double[] weight = {};
  private double ways;
  private long steps;

  TargetTracks(Parameters parameters, SiteSight sight, int capacity) {
    this.parameters = parameters;
    this.sight = sight;
    grow(capacity);
  }

  private void grow(int capacity) {
    known = Arrays.copyOf(known, capacity);
    list = Arrays.copyOf(list, capacity);
    x = Arrays.copyOf(x, capacity);
    y = Arrays.copyOf(y, capacity);
    wayX = Arrays.copyOf(wayX, capacity);
    wayY = Arrays.copyOf(wayY, capacity);
    seenX = Arrays.copyOf(seenX, capacity);
    seenY = Arrays.copyOf(seenY, capacity);
    seenAt = Arrays.copyOf(seenAt, capacity);
    size = Arrays.copyOf(size, capacity);
    weight = Arrays.copyOf(weight, capacity);
  }

  /** A number that no target has, from one on. */
  int unused(int from) {
    int track = from;
    while (track < known.length && known[track]) {
      track++;
    }
    if (track == known.length) {
      grow(Math.max(1, 2 * track));
    }
    return track;
  }

  /** All go on by a step. */
  void step() {
    for (int i = 0; i < count; i++) {
      move(list[i]);
      weight[list[i]] *= parameters.decay();
    }
  }

  private void move(int track) {
    double toX = x[track] + wayX[track];
    double toY = y[track] + wayY[track];
    if (sight.isWay(x[track], y[track], toX, toY)) {
      x[track] = toX;
      y[track] = toY;
    }
  }

  /**
   * A target is seen, or was.
   *
   * @param step in which it was
   * @param now the step that is under way
   * @return whether that is new
   */
  boolean see(int track, long step, long now, double atX, double atY, double itsSize) {
    if (known[track] && seenAt[track] >= step) {
      return false;
    }
    if (known[track]) {
      turn(track, step - seenAt[track], atX - seenX[track], atY - seenY[track]);
    } else {
      known[track] = true;
      list[count++] = track;
      wayX[track] = 0;
      wayY[track] = 0;
    }
    seenX[track] = atX;
    seenY[track] = atY;
    seenAt[track] = step;
    size[track] = itsSize;
    place(track, now - step);
    return true;
  }

  private void turn(int track, long passed, double dx, double dy) {
    wayX[track] = dx / passed;
    wayY[track] = dy / passed;
    ways += Math.sqrt(dx * dx + dy * dy);
    steps += passed;
  }

  private void place(int track, long passed) {
    x[track] = seenX[track];
    y[track] = seenY[track];
    weight[track] = Math.pow(parameters.decay(), (double) passed);
    for (long step = 0; step < passed; step++) {
      move(track);
    }
  }

  /**
   * A camera that looks at where a target should be does not see it: by Bayes' rule it is less
   * likely to be there.
   *
   * @param chance that the camera would have detected it
   * @return by how much
   */
  double miss(int track, double chance) {
    double before = weight[track];
    double seen = before * chance;
    weight[track] = seen >= 1 ? 0 : (before - seen) / (1 - seen);
    return before - weight[track];
  }

  /** Forgets targets that were last seen long ago, or are hardly there; the map takes them. */
  void forget(long now, SearchMap map) {
    int kept = 0;
    for (int i = 0; i < count; i++) {
      int track = list[i];
      known[track] = now - seenAt[track] <= parameters.memory() && weight[track] >= FEW;
      if (known[track]) {
        list[kept++] = track;
      } else {
        map.absorb(x[track], y[track], weight[track]);
      }
    }
    count = kept;
  }

  /** Says where a target is going to be in each step of a forecast, from a slot on. */
  void follow(int track, Forecast forecast, int firstSlot) {
    double atX = x[track];
    double atY = y[track];
    for (int step = 0; step < forecast.horizon(); step++) {
      forecast.set(firstSlot + step, atX, atY, size[track], weight[track]);
      if (sight.isWay(atX, atY, atX + wayX[track], atY + wayY[track])) {
        atX += wayX[track];
        atY += wayY[track];
      }
    }
  }

  /** How many targets are known. */
  int count() {
    return count;
  }

  /** One of them, by its place in the list. */
  int at(int i) {
    return list[i];
  }

  double x(int track) {
    return x[track];
  }

  double y(int track) {
    return y[track];
  }

  /** Where it was some steps ago, metres, as far as is known. */
  double x(int track, long ago) {
    return x[track] - ago * wayX[track];
  }

  double y(int track, long ago) {
    return y[track] - ago * wayY[track];
  }

  double size(int track) {
    return size[track];
  }

  /** How likely it still is where it is believed to be, (0, 1]. */
  double weight(int track) {
    return weight[track];
  }

  /** The step in which it was last seen. */
  long seenAt(int track) {
    return seenAt[track];
  }

  /** How far a target goes in a step on average, metres; 0 before any was seen twice. */
  double meanWay() {
    return steps == 0 ? 0 : ways / steps;
  }
}
