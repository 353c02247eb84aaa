package org.hificamsim.agents.optimal;

import java.util.Arrays;
import org.hificamsim.agents.search.CoverageProblem;

/**
 * The maximal sets of targets that a camera can have in its sector when it may pan to any angle of
 * a range (MaxFoV, INFOCOM 2014): at most one for each target. What is not maximal, no
 * configuration needs.
 *
 * <p>Each target is in sight over an interval of pan angles, so that every maximal set is in sight
 * where one of these intervals, or the range, ends. The sector's borders belong to it. Bearings and
 * angles are in radians, turning the same way; nothing is allocated after construction.
 */
public final class PanSweep {
  private static final double TURN = 2 * Math.PI;

  /** Radians of rounding that a target on a border may be off. */
  private static final double SLACK = 1e-12;

  private final int words;
  private final long[] masks;
  private final double[] pans;
  private int count;

  /** With room for this number of targets. */
  public PanSweep(int maxTargets) {
    words = CoverageProblem.wordsFor(maxTargets);
    masks = new long[(maxTargets + 2) * words];
    pans = new double[maxTargets + 2];
  }

  /**
   * Finds the maximal sets.
   *
   * @param bearings of the targets in reach, as the camera sees them
   * @param targets how many there are; target i is bit i of the masks
   * @param opening of the sector, above 0
   * @param from least pan angle: the bearing of the sector's axis
   * @param to greatest pan angle, {@code from} or more; a whole turn away where there is no end
   */
  public void sweep(double[] bearings, int targets, double opening, double from, double to) {
    count = 0;
    for (int first = 0; first < targets; first++) {
      if (turned(bearings[first] + opening / 2 - from) <= to - from) {
        add(bearings, targets, opening, bearings[first], from, to);
      }
    }
    add(bearings, targets, opening, from - opening / 2, from, to);
    add(bearings, targets, opening, to - opening / 2, from, to);
  }

  /** Adds what the sector that begins at a bearing has in sight. */
  private void add(
      double[] bearings, int targets, double opening, double begin, double from, double to) {
    int at = count * words;
    Arrays.fill(masks, at, at + words, 0);
    double nearest = TURN;
    double farthest = 0;
    for (int target = 0; target < targets; target++) {
      double offset = offset(bearings[target] - begin);
      if (offset <= opening + SLACK) {
        masks[at + (target >> 6)] |= 1L << target;
        nearest = Math.min(nearest, offset);
        farthest = Math.max(farthest, offset);
      }
    }
    if (farthest > 0 || nearest < TURN) {
      pans[count] = within(begin + (nearest + farthest) / 2, from, to);
      keepMaximal();
    }
  }

  /** Keeps the last set where no other has all of it, and drops those that it has all of. */
  private void keepMaximal() {
    for (int i = 0; i < count; i++) {
      if (within(count, i)) {
        return;
      }
    }
    int kept = 0;
    for (int i = 0; i <= count; i++) {
      if (i == count || !within(i, count)) {
        System.arraycopy(masks, i * words, masks, kept * words, words);
        pans[kept++] = pans[i];
      }
    }
    count = kept;
  }

  private boolean within(int set, int other) {
    boolean within = true;
    for (int word = 0; word < words; word++) {
      within &= (masks[set * words + word] & ~masks[other * words + word]) == 0;
    }
    return within;
  }

  /** The pan angle of the range that is nearest. */
  private static double within(double pan, double from, double to) {
    double beyond = turned(pan - from);
    if (beyond <= to - from) {
      return from + beyond;
    }
    return beyond - (to - from) < TURN - beyond ? to : from;
  }

  /** An angle in [0, 2 pi); one just below a whole turn is 0, as rounding has it. */
  private static double offset(double angle) {
    double turned = turned(angle);
    return turned > TURN - SLACK ? 0 : turned;
  }

  private static double turned(double angle) {
    return angle - TURN * Math.floor(angle / TURN);
  }

  /** The number of maximal sets; 0 where no target can be in sight. */
  public int count() {
    return count;
  }

  /** A pan angle at which all targets of the i-th set are in the sector, radians. */
  public double pan(int i) {
    return pans[i];
  }

  /** One word of the i-th set's mask. */
  public long mask(int i, int word) {
    return masks[i * words + word];
  }
}
