package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.obstacle.Obstacles;

/**
 * Targets that were seen lately: where each one is now, as far as is known, and how it moves. While
 * nobody sees them they go on as they went, up to the next obstacle.
 */
final class TargetTracks {
  private static final double FEW = 0.05; // what is left of a track that is given up

  private static final class Track {
    private boolean known;
    private double x;
    private double y;
    private double wayX; // of a step
    private double wayY;
    private double seenX;
    private double seenY;
    private long seenAt; // step
    private double size;
    private double weight;
  }

  private final Parameters parameters;
  private final Obstacles map;
  private Track[] of = {}; // by number
  private int[] list = {}; // of those that are known
  private int count;
  private double ways;
  private long steps;

  TargetTracks(Parameters parameters, Obstacles map, int capacity) {
    this.parameters = parameters;
    this.map = map;
    grow(capacity);
  }

  private void grow(int capacity) {
    of = Arrays.copyOf(of, capacity);
    list = Arrays.copyOf(list, capacity);
    Arrays.setAll(of, track -> of[track] == null ? new Track() : of[track]);
  }

  /** A number that no target has, from one on. */
  int unused(int from) {
    int track = from;
    while (track < of.length && of[track].known) {
      track++;
    }
    if (track == of.length) {
      grow(Math.max(1, 2 * track));
    }
    return track;
  }

  /** All go on by a step. */
  void step() {
    for (int i = 0; i < count; i++) {
      move(list[i]);
      of[list[i]].weight *= parameters.decay();
    }
  }

  private void move(int track) {
    double toX = of[track].x + of[track].wayX;
    double toY = of[track].y + of[track].wayY;
    if (map.clear(of[track].x, of[track].y, toX, toY)) {
      of[track].x = toX;
      of[track].y = toY;
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
    if (of[track].known && of[track].seenAt >= step) {
      return false;
    }
    if (of[track].known) {
      turn(track, step - of[track].seenAt, atX - of[track].seenX, atY - of[track].seenY);
    } else {
      of[track].known = true;
      list[count++] = track;
      of[track].wayX = 0;
      of[track].wayY = 0;
    }
    of[track].seenX = atX;
    of[track].seenY = atY;
    of[track].seenAt = step;
    of[track].size = itsSize;
    place(track, now - step);
    return true;
  }

  private void turn(int track, long passed, double dx, double dy) {
    of[track].wayX = dx / passed;
    of[track].wayY = dy / passed;
    ways += Math.sqrt(dx * dx + dy * dy);
    steps += passed;
  }

  private void place(int track, long passed) {
    of[track].x = of[track].seenX;
    of[track].y = of[track].seenY;
    of[track].weight = Math.pow(parameters.decay(), (double) passed);
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
    double before = of[track].weight;
    double seen = before * chance;
    of[track].weight = seen >= 1 ? 0 : (before - seen) / (1 - seen);
    return before - of[track].weight;
  }

  /** Forgets targets that were last seen long ago, or are hardly there; the map takes them. */
  void forget(long now, SearchMap map) {
    int kept = 0;
    for (int i = 0; i < count; i++) {
      int track = list[i];
      of[track].known = now - of[track].seenAt <= parameters.memory() && of[track].weight >= FEW;
      if (of[track].known) {
        list[kept++] = track;
      } else {
        map.absorb(of[track].x, of[track].y, of[track].weight);
      }
    }
    count = kept;
  }

  /** Says where a target is going to be in each step of a forecast, from a slot on. */
  void follow(int track, Forecast forecast, int firstSlot) {
    double atX = of[track].x;
    double atY = of[track].y;
    for (int step = 0; step < forecast.horizon(); step++) {
      forecast.set(firstSlot + step, atX, atY, of[track].size, of[track].weight);
      if (map.clear(atX, atY, atX + of[track].wayX, atY + of[track].wayY)) {
        atX += of[track].wayX;
        atY += of[track].wayY;
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
    return of[track].x;
  }

  double y(int track) {
    return of[track].y;
  }

  /** Where it was some steps ago, metres, as far as is known. */
  double x(int track, long ago) {
    return of[track].x - ago * of[track].wayX;
  }

  double y(int track, long ago) {
    return of[track].y - ago * of[track].wayY;
  }

  double size(int track) {
    return of[track].size;
  }

  /** How likely it still is where it is believed to be, (0, 1]. */
  double weight(int track) {
    return of[track].weight;
  }

  /** The step in which it was last seen. */
  long seenAt(int track) {
    return of[track].seenAt;
  }

  /** How far a target goes in a step on average, metres; 0 before any was seen twice. */
  double meanWay() {
    return steps == 0 ? 0 : ways / steps;
  }
}
