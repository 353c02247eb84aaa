package org.hificamsim.network.agent;

import java.util.BitSet;

/** The targets that a camera has advertised, and whom it asked about each. */
final class Advertised {
  private final BitSet open = new BitSet();
  private final BitSet[] asked;

  Advertised(int targets) {
    asked = new BitSet[targets];
  }

  /** Notes that a target is advertised, though no camera that can be named was asked. */
  void open(int target) {
    if (!open.get(target)) {
      open.set(target);
      asked[target] = asked[target] == null ? new BitSet() : asked[target];
      asked[target].clear();
    }
  }

  /** Notes that a name was asked about an advertised target. */
  void add(int target, int name) {
    asked[target].set(name);
  }

  /** Forgets that a name was asked; the target stays advertised. */
  void remove(int target, int name) {
    if (open.get(target)) {
      asked[target].clear(name);
    }
  }

  /** Notes that a target is no longer advertised. */
  void close(int target) {
    open.clear(target);
  }

  boolean contains(int target) {
    return open.get(target);
  }

  boolean isEmpty() {
    return open.isEmpty();
  }

  /** The names that were asked about an advertised target. */
  BitSet asked(int target) {
    return asked[target];
  }
}
