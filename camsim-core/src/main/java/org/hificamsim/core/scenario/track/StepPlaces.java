package org.hificamsim.core.scenario.track;

import java.util.Arrays;
import java.util.List;

/**
 * The precomputed positions of a target at its steps. The positions of all targets of a file are in
 * one array in the order in which a run needs them: a block of eight steps, target by target, then
 * the next block. Without this order a step of many tracks takes 1.5 times as long, because of
 * cache misses.
 */
public final class StepPlaces {
  /** The greatest number of precomputed positions, 16 bytes each; larger files have none. */
  static final int MAX_PLACES = 1 << 23;

  private static final int SHIFT = 3;
  private static final int STEPS_PER_BLOCK = 1 << SHIFT;

  private final Track track;
  private final long first;
  private final long last;

  /** The alternating x and y of all targets. */
  private final double[] coordinates;

  /** The start of each block of this target in {@link #coordinates}. */
  private final int[] blockStarts;

  private int arrangedBlocks;

  private StepPlaces(Track track, double[] coordinates) {
    this.track = track;
    this.coordinates = coordinates;
    first = track.firstStep();
    last = track.lastStep();
    blockStarts = new int[steps(track) == 0 ? 0 : block(last) + 1];
  }

  /**
   * Precomputes the positions of tracks and stores them in the tracks, unless there are too many.
   */
  public static void precompute(List<Track> tracks) {
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
    long[] order =
        new long[Arrays.stream(places).mapToInt(target -> target.blockStarts.length).sum()];
    int count = 0;
    for (int target = 0; target < places.length; target++) {
      long block = places[target].first >> SHIFT;
      for (int i = 0; i < places[target].blockStarts.length; i++) {
        order[count++] = ((block + i) << Integer.SIZE) | target;
      }
    }
    Arrays.sort(order);
    int begin = 0;
    for (long next : order) {
      begin = places[(int) next].arrangeBlock(begin);
    }
  }

  /** Sets the start of the target's next block; returns its end. */
  private int arrangeBlock(int begin) {
    long step = Math.max(first, ((first >> SHIFT) + arrangedBlocks) << SHIFT);
    blockStarts[arrangedBlocks++] = begin;
    return begin + 2 * (following(step) + 1);
  }

  private void fill() {
    TrackWalk walk = new TrackWalk();
    walk.begin(track, first);
    for (long step = first; step <= last; step++) {
      int index = indexOf(step);
      coordinates[index] = walk.x();
      coordinates[index + 1] = walk.y();
      walk.next();
    }
    track.store(this);
  }

  private int block(long step) {
    return (int) ((step >> SHIFT) - (first >> SHIFT));
  }

  /** Whether the target is present at a step. */
  boolean has(long step) {
    return step >= first && step <= last;
  }

  /** The index of the position at a step. */
  int indexOf(long step) {
    int block = block(step);
    long begin = block == 0 ? first : step & -STEPS_PER_BLOCK;
    return blockStarts[block] + 2 * (int) (step - begin);
  }

  /** The number of steps after this one whose positions follow directly. */
  int following(long step) {
    return (int) Math.min(step | (STEPS_PER_BLOCK - 1), last) - (int) step;
  }

  /** The alternating x and y of all targets, in metres. */
  double[] coordinates() {
    return coordinates;
  }
}
