package org.hificamsim.network.agent;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.function.IntUnaryOperator;

/**
 * One camera's part of the vision graph: a strength for each name that it has handed targets to, by
 * category of the targets (behaviour 8.1, 8.7). A plain schedule has one category for all.
 *
 * <p>Names are numbered: cameras by their number, names in the file's graph without a camera after
 * them.
 */
public final class Links {
  /** The strength that stands for no link. */
  static final double NONE = -1;

  /** The factor by which a link fades in a step. */
  private static final double FADING = 0.995;

  /** The links of a camera that never reads them. */
  public static final Links UNREAD = plain(0, List.of(), true);

  private final int categories;
  private final IntUnaryOperator categoryOf;
  private final double[] strengths;
  private final BitSet linked = new BitSet();
  private boolean frozen;

  private Links(int names, int categories, IntUnaryOperator categoryOf) {
    this.categories = categories;
    this.categoryOf = categoryOf;
    strengths = new double[names * (categories + 1)];
    Arrays.fill(strengths, NONE);
  }

  /**
   * Creates links that are the same for all targets.
   *
   * @param initial the names linked at the start, with strength 1
   * @param frozen whether links neither fade nor grow
   */
  public static Links plain(int names, List<Integer> initial, boolean frozen) {
    Links links = new Links(names, 1, target -> 1);
    for (int name : initial) {
      links.linked.set(name);
      links.strengths[links.index(name, 1)] = 1.0;
    }
    links.frozen = frozen;
    return links;
  }

  /**
   * Creates links by category of targets, none at the start.
   *
   * @param categoryOf gives the category of a target, 1 to {@code categories}, or 0 for none
   */
  public static Links byCategory(int names, int categories, IntUnaryOperator categoryOf) {
    return new Links(names, categories, categoryOf);
  }

  /** The strength of the link to a name for a target, or {@link #NONE}. */
  double strength(int name, int target) {
    return strengths[index(name, categoryOf.applyAsInt(target))];
  }

  /** The greatest strength of a link for a target; 0 without links. */
  double strongest(int target) {
    int category = categoryOf.applyAsInt(target);
    double strongest = 0;
    for (int name = linked.nextSetBit(0); name >= 0; name = linked.nextSetBit(name + 1)) {
      strongest = Math.max(strongest, strengths[index(name, category)]);
    }
    return strongest;
  }

  /** Strengthens the link to a camera that a target was handed to. */
  void strengthen(int camera, int target) {
    int category = categoryOf.applyAsInt(target);
    if (frozen || category == 0) {
      return;
    }
    int cell = index(camera, category);
    strengths[cell] = strengths[cell] == NONE ? 1.0 : strengths[cell] + 1.0;
    linked.set(camera);
  }

  /** Fades every link; called once per step. */
  void fade() {
    if (frozen) {
      return;
    }
    for (int name = linked.nextSetBit(0); name >= 0; name = linked.nextSetBit(name + 1)) {
      for (int cell = index(name, 1); cell <= index(name, categories); cell++) {
        if (strengths[cell] != NONE) {
          strengths[cell] *= FADING;
        }
      }
    }
  }

  /** Lets links fade and grow from now on. */
  void thaw() {
    frozen = false;
  }

  /** The linked names. */
  BitSet linked() {
    return linked;
  }

  private int index(int name, int category) {
    return name * (categories + 1) + category;
  }
}
