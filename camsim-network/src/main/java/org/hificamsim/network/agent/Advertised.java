package org.hificamsim.network.agent;

import java.util.BitSet;

/** The targets that a camera has advertised, and which cameras it asked about each. */
public final class Advertised {
  private final BitSet[] asked;
  private final boolean[] open;
  private int size;

  Advertised(int targets) {
    asked = new BitSet[targets];
    open = new boolean[targets];
  }

  /** Notes that the target is advertised, though no camera that can be named was asked. */
  public void open(int target) {
    if (open[target]) {
      return;
    }
    open[target] = true;
    size++;
    if (asked[target] == null) {
      asked[target] = new BitSet();
    }
    asked[target].clear();
  }

  /** Notes that a camera was asked. */
  public void add(int target, int camera) {
    open(target);
    asked[target].set(camera);
  }

  /** Forgets that a camera was asked; the target stays advertised. */
  public void remove(int target, int camera) {
    if (open[target]) {
      asked[target].clear(camera);
    }
  }

  /** Notes that the target is no longer advertised. */
  public void close(int target) {
    if (open[target]) {
      open[target] = false;
      size--;
    }
  }

  public boolean contains(int target) {
    return open[target];
  }

  public boolean isEmpty() {
    return size == 0;
  }

  /** The first camera from {@code camera} on that was asked about an advertised target, or -1. */
  public int nextAsked(int target, int camera) {
    return asked[target].nextSetBit(camera);
  }
}
