package org.hificamsim.network.agent;

import java.util.Arrays;

/**
 * The targets that a camera looks for, and for whom, in the order of insertion (behaviour 4.6): as
 * all cameras do, unless it has heard something else since.
 */
final class Searches {
  /** Nobody owns the target: whoever sees it first may have it. */
  static final int NOBODY = -1;

  /** The camera does not look for the target. */
  static final int NONE = -2;

  private final int camera;
  private final SharedSearches shared;
  private final int[] searcher;
  private final long[] since;
  private final long[] changed;
  private final boolean[] listed;
  private int[] own = new int[8];
  private int owns;
  private boolean deaf;

  /** Looks for nothing, whatever the others do. */
  Searches(int camera, SharedSearches shared, int targets) {
    this.camera = camera;
    this.shared = shared;
    searcher = new int[targets];
    since = new long[targets];
    changed = new long[targets];
    listed = new boolean[targets];
    for (int target = 0; target < targets; target++) {
      remove(target);
    }
  }

  int camera() {
    return camera;
  }

  /** Looks for a target from now on, for this camera or for {@link #NOBODY}. */
  void put(int target, int forCamera) {
    long now = shared.tick();
    set(target, forCamera, contains(target) ? since(target) : now, now);
    if (forCamera == camera) {
      list(target);
    }
  }

  /** Looks for a target for another camera, which began at {@code time}. */
  void hear(int target, int from, long time) {
    set(target, from, contains(target) ? since(target) : time, shared.tick());
  }

  void remove(int target) {
    if (contains(target)) {
      set(target, NONE, 0, shared.tick());
    }
  }

  private void set(int target, int forCamera, long first, long now) {
    if (!isApart(target)) {
      shared.leave(target);
    }
    searcher[target] = forCamera;
    since[target] = first;
    changed[target] = now;
  }

  private void list(int target) {
    if (!listed[target]) {
      listed[target] = true;
      own = owns == own.length ? Arrays.copyOf(own, 2 * owns) : own;
      own[owns++] = target;
    }
  }

  /** A camera that is offline hears nothing, and knows what it knew when it is back. */
  void listen(boolean online) {
    if (online == deaf) {
      for (int target = 0; target < searcher.length; target++) {
        turn(target, online);
      }
      deaf = !online;
    }
  }

  private void turn(int target, boolean online) {
    if (online) {
      shared.leave(target);
    } else if (isApart(target)) {
      shared.forget(target);
    } else {
      searcher[target] = shared.searcher(target);
      since[target] = shared.since(target);
    }
    changed[target] = shared.tick();
  }

  /** Whether the camera has heard something else of a target than all did last. */
  boolean isApart(int target) {
    return deaf || changed[target] > shared.changed(target);
  }

  /** When what the camera knows of a target changed last; all did later where it is not apart. */
  long changed(int target) {
    return changed[target];
  }

  boolean contains(int target) {
    return searcher(target) != NONE;
  }

  /** For whom the camera looks for a target; {@link #NONE} where it does not. */
  int searcher(int target) {
    return isApart(target) ? searcher[target] : shared.searcher(target);
  }

  /** Since when, for a target that the camera looks for. */
  long since(int target) {
    return isApart(target) ? since[target] : shared.since(target);
  }

  /** Finds the targets that it looks for itself; returns how many {@link #own} has in order. */
  int findOwn() {
    int found = 0;
    for (int i = 0; i < owns; i++) {
      int target = own[i];
      listed[target] = searcher(target) == camera;
      if (listed[target]) {
        insert(target, found++);
      }
    }
    owns = found;
    return found;
  }

  private void insert(int target, int end) {
    int place = end;
    while (place > 0 && since(own[place - 1]) > since(target)) {
      own[place] = own[place - 1];
      place--;
    }
    own[place] = target;
  }

  /** A target as {@link #findOwn} found it. */
  int own(int index) {
    return own[index];
  }
}
