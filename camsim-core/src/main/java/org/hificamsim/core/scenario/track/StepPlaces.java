package org.hificamsim.core.scenario.track;

import java.util.Arrays;
import java.util.List;

/**
 * Where a target is at each of its steps. The places of all targets of a file lie in one array in
 * the order in which a run asks for them: a block of eight steps, target by target, then the next
 * block. Read in a thousand places of memory, tracks made a step half as long again.
 */
public final class StepPlaces {
  /** Places that are computed in advance, 16 bytes each; a file with more has none. */
  static final int MAX_PLACES = 1 << 23;

  private static final int SHIFT = 3;
  private static final int BLOCK = 1 << SHIFT; // steps

  private final Track track;
  private final long first;
  private final long last;
  private final double[] coordinates; // x and y in turn, of all targets
  private final int[] begins; // of this target's blocks
  private int filled;

  private StepPlaces(Track track, double[] coordinates) {
    this.track = track;
    this.coordinates = coordinates;
    first = track.firstStep();
    last = track.lastStep();
    begins = new int[steps(track) == 0 ? 0 : block(last) + 1];
  }

  /**
   * Works out the places of these tracks, unless they are too many, and gives them to the tracks.
   */
  public static void keep(List<Track> tracks) {
    long total = tracks.stream().mapToLong(StepPlaces::steps).sum();
    if (total <= MAX_PLACES) {
      double[] coordinates = new double[2 * (int) total];
      StepPlaces[] places =
          tracks.stream()
              .map(track -> new StepPlaces(track, coordinates))
              .toArray(StepPlaces[]::new);
      arrange(places);
      Arrays.stream(places).forEach(StepPlaces::fill);
    }
  }

  private static long steps(Track track) {
    return Math.max(0, track.lastStep() - track.firstStep() + 1);
  }

  private static void arrange(StepPlaces[] places) {
    long[] order = new long[Arrays.stream(places).mapToInt(one -> one.begins.length).sum()];
    int count = 0;
    for (int target = 0; target < places.length; target++) {
      long block = places[target].first >> SHIFT;
      for (int i = 0; i < places[target].begins.length; i++) {
        order[count++] = ((block + i) << Integer.SIZE) | target;
      }
    }
    Arrays.sort(order);
    int begin = 0;
    for (long next : order) {
      begin = places[(int) next].begin(begin);
    }
  }

  /** Puts the target's next block there; returns where it ends. */
  private int begin(int begin) {
    long step = Math.max(first, ((first >> SHIFT) + filled) << SHIFT);
    begins[filled++] = begin;
    return begin + 2 * (following(step) + 1);
  }

  private void fill() {
    TrackWalk walk = new TrackWalk();
    walk.begin(track, first);
    for (long step = first; step <= last; step++) {
      int at = at(step);
      coordinates[at] = walk.x();
      coordinates[at + 1] = walk.y();
      walk.next();
    }
    track.keep(this);
  }

  private int block(long step) {
    return (int) ((step >> SHIFT) - (first >> SHIFT));
  }

  /** Whether the target is there. */
  boolean has(long step) {
    return step >= first && step <= last;
  }

  /** Where the place of a step is. */
  int at(long step) {
    int block = block(step);
    long begin = block == 0 ? first : step & -BLOCK;
    return begins[block] + 2 * (int) (step - begin);
  }

  /** How many steps after this one have their places right behind it. */
  int following(long step) {
    return (int) Math.min(step | (BLOCK - 1), last) - (int) step;
  }

  /** Metres. */
  double[] coordinates() {
    return coordinates;
  }
}
