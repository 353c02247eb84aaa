package org.hificamsim.network.agent;

import java.util.Arrays;
import java.util.List;

/** The vision graph's plain links: one strength a name, whatever the target. */
public final class NameLinks implements Links {
  /** What is left of a link after a step. */
  static final double FADING = 0.995;

  private final double[] strengths;
  private final int[] linked;
  private int count;
  private boolean frozen;

  /**
   * @param names how many names there are
   * @param initial names linked to at the start, with strength 1
   * @param frozen whether links neither fade nor grow
   */
  public NameLinks(int names, List<Integer> initial, boolean frozen) {
    strengths = new double[names];
    linked = new int[names];
    Arrays.fill(strengths, NONE);
    initial.forEach(this::link);
    this.frozen = frozen;
  }

  @Override
  public double strength(int name, int target) {
    return strengths[name];
  }

  @Override
  public double strongest(int target) {
    double most = 0;
    for (int i = 0; i < count; i++) {
      most = Math.max(most, strengths[linked[i]]);
    }
    return most;
  }

  @Override
  public void strengthen(int camera, int target) {
    if (frozen) {
      return;
    }
    if (strengths[camera] == NONE) {
      link(camera);
    } else {
      strengths[camera] += 1.0;
    }
  }

  @Override
  public void decay() {
    if (frozen) {
      return;
    }
    for (int i = 0; i < count; i++) {
      strengths[linked[i]] *= FADING;
    }
  }

  @Override
  public void thaw() {
    frozen = false;
  }

  @Override
  public int count() {
    return count;
  }

  @Override
  public int name(int index) {
    return linked[index];
  }

  private void link(int name) {
    if (strengths[name] == NONE) {
      linked[count++] = name;
    }
    strengths[name] = 1.0;
  }
}
