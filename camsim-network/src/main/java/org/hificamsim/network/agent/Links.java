package org.hificamsim.network.agent;

import java.util.Arrays;
import java.util.BitSet;
import java.util.List;
import java.util.function.IntUnaryOperator;

/**
 * One camera's part of the vision graph: a strength for each name that it handed targets to, by
 * category of the targets (behaviour 8.1, 8.7). A plain schedule has one category for all.
 *
 * <p>Names are numbered: cameras by their number, names in the file's graph without a camera after
 * them.
 */
public final class Links {
  /** What stands for no link. */
  static final double NONE = -1;

  /** What is left of a link after a step. */
  private static final double FADING = 0.995;

  /** Those of a camera that never looks at them. */
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
   * The same links for all targets.
   *
   * @param initial names linked to at the start, with strength 1
   * @param frozen whether links neither fade nor grow
   */
  public static Links plain(int names, List<Integer> initial, boolean frozen) {
    Links links = new Links(names, 1, target -> 1);
    for (int name : initial) {
      links.linked.set(name);
      links.strengths[links.at(name, 1)] = 1.0;
    }
    links.frozen = frozen;
    return links;
  }

  /**
   * Links for each category of targets, none at the start.
   *
   * @param categoryOf the category of a target, 1 to {@code categories}, or 0 for none
   */
  public static Links byCategory(int names, int categories, IntUnaryOperator categoryOf) {
    return new Links(names, categories, categoryOf);
  }

  /** The strength of the link to a name for this target, or {@link #NONE}. */
  double strength(int name, int target) {
    return strengths[at(name, categoryOf.applyAsInt(target))];
  }

  /** The greatest strength for this target; 0 without links. */
  double strongest(int target) {
    int category = categoryOf.applyAsInt(target);
    double strongest = 0;
    for (int name = linked.nextSetBit(0); name >= 0; name = linked.nextSetBit(name + 1)) {
      strongest = Math.max(strongest, strengths[at(name, category)]);
    }
    return strongest;
  }

  /** Notes a handover of the target to a camera. */
  void strengthen(int camera, int target) {
    int category = categoryOf.applyAsInt(target);
    if (frozen || category == 0) {
      return;
    }
    int place = at(camera, category);
    strengths[place] = strengths[place] == NONE ? 1.0 : strengths[place] + 1.0;
    linked.set(camera);
  }

  /** Lets every link fade, once per step. */
  void decay() {
    if (frozen) {
      return;
    }
    for (int name = linked.nextSetBit(0); name >= 0; name = linked.nextSetBit(name + 1)) {
      for (int place = at(name, 1); place <= at(name, categories); place++) {
        if (strengths[place] != NONE) {
          strengths[place] *= FADING;
        }
      }
    }
  }

  /** Lets links fade and grow from now on. */
  void thaw() {
    frozen = false;
  }

  /** The names linked to. */
  BitSet linked() {
    return linked;
  }

  private int at(int name, int category) {
    return name * (categories + 1) + category;
  }
}
