package org.hificamsim.network.agent;

import java.util.Arrays;
import java.util.function.IntUnaryOperator;

/**
 * The links of a historical schedule: a strength for each name and category of targets, none at the
 * start, never frozen (behaviour 8.7).
 */
public final class CategoryLinks implements Links {
  private final double[] strengths;
  private final int[] linked;
  private final boolean[] isLinked;
  private final int categories;
  private final IntUnaryOperator categoryOf;
  private int count;

  /**
   * @param cameras how many there are
   * @param categoryOf the category of a target, 1 to {@code categories}, or 0 for none
   */
  public CategoryLinks(int cameras, int categories, IntUnaryOperator categoryOf) {
    this.categories = categories;
    this.categoryOf = categoryOf;
    strengths = new double[cameras * (categories + 1)];
    linked = new int[cameras];
    isLinked = new boolean[cameras];
    Arrays.fill(strengths, NONE);
  }

  @Override
  public double strength(int name, int target) {
    return name >= linked.length ? NONE : strengths[at(name, categoryOf.applyAsInt(target))];
  }

  @Override
  public double strongest(int target) {
    int category = categoryOf.applyAsInt(target);
    double most = 0;
    for (int i = 0; i < count; i++) {
      most = Math.max(most, strengths[at(linked[i], category)]);
    }
    return most;
  }

  @Override
  public void strengthen(int camera, int target) {
    int category = categoryOf.applyAsInt(target);
    if (category == 0) {
      return;
    }
    int place = at(camera, category);
    strengths[place] = strengths[place] == NONE ? 1.0 : strengths[place] + 1.0;
    if (!isLinked[camera]) {
      isLinked[camera] = true;
      linked[count++] = camera;
    }
  }

  @Override
  public void decay() {
    for (int i = 0; i < count; i++) {
      for (int category = 1; category <= categories; category++) {
        int place = at(linked[i], category);
        if (strengths[place] != NONE) {
          strengths[place] *= NameLinks.FADING;
        }
      }
    }
  }

  @Override
  public int count() {
    return count;
  }

  @Override
  public int name(int index) {
    return linked[index];
  }

  private int at(int name, int category) {
    return name * (categories + 1) + category;
  }
}
