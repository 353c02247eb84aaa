package org.hificamsim.core.silhouette;

import java.util.Arrays;

/** A linked list of nearer targets for each target. Reuse an instance: it keeps its arrays. */
final class NearerTargets {
  private static final int NONE = -1;

  /** The first link of each target. */
  private final int[] firsts;

  private int[] others = new int[64];
  private int[] nexts = new int[64];
  private int links;

  NearerTargets(int targets) {
    firsts = new int[targets];
    clear();
  }

  void clear() {
    Arrays.fill(firsts, NONE);
    links = 0;
  }

  void add(int target, int other) {
    if (links == others.length) {
      others = Arrays.copyOf(others, 2 * links);
      nexts = Arrays.copyOf(nexts, 2 * links);
    }
    others[links] = other;
    nexts[links] = firsts[target];
    firsts[target] = links++;
  }

  /** The first link of a target; negative if there is none. */
  int first(int target) {
    return firsts[target];
  }

  /** The link after another one; negative if there is none. */
  int next(int link) {
    return nexts[link];
  }

  /** The nearer target of a link. */
  int target(int link) {
    return others[link];
  }
}
