package org.hificamsim.network.agent;

/** The cameras that a camera can talk to, in list order. */
public final class Neighbours {
  private final int[] cameras;
  private final boolean[] member;
  private int count;

  Neighbours(int bound) {
    cameras = new int[bound];
    member = new boolean[bound];
  }

  /** Appends a camera. */
  public void add(int camera) {
    member[camera] = true;
    cameras[count++] = camera;
  }

  /** Removes all, for good (behaviour 7, step 4). */
  public void clear() {
    for (int i = 0; i < count; i++) {
      member[cameras[i]] = false;
    }
    count = 0;
  }

  public boolean contains(int camera) {
    return member[camera];
  }

  public int count() {
    return count;
  }

  public int get(int index) {
    return cameras[index];
  }
}
