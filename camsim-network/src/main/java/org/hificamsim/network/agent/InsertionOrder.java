package org.hificamsim.network.agent;

import java.util.Arrays;

/**
 * A set of small numbers that is iterated in the order of insertion; inserting a member again keeps
 * its place (behaviour 4.6). Nothing is allocated after construction.
 */
public final class InsertionOrder {
  /** No member: the end of an iteration. */
  public static final int END = -1;

  private final int[] next;
  private final int[] previous;
  private final boolean[] member;
  private int first = END;
  private int last = END;
  private int size;

  /** An empty set of numbers from 0 to {@code bound} - 1. */
  public InsertionOrder(int bound) {
    next = new int[bound];
    previous = new int[bound];
    member = new boolean[bound];
    Arrays.fill(next, END);
    Arrays.fill(previous, END);
  }

  /** Appends the number unless it is a member. */
  public void add(int number) {
    if (member[number]) {
      return;
    }
    member[number] = true;
    size++;
    next[number] = END;
    previous[number] = last;
    if (last == END) {
      first = number;
    } else {
      next[last] = number;
    }
    last = number;
  }

  /** Removes the number if it is a member; an iteration reads {@link #next} first. */
  public void remove(int number) {
    if (!member[number]) {
      return;
    }
    member[number] = false;
    size--;
    if (number == first) {
      first = next[number];
    } else {
      next[previous[number]] = next[number];
    }
    if (number == last) {
      last = previous[number];
    } else {
      previous[next[number]] = previous[number];
    }
  }

  /** Removes all members. */
  public void clear() {
    while (first != END) {
      remove(first);
    }
  }

  /** Whether the number is a member. */
  public boolean contains(int number) {
    return member[number];
  }

  /** The number of members. */
  public int size() {
    return size;
  }

  /** The first member, or {@link #END}. */
  public int first() {
    return first;
  }

  /** The member after this one, or {@link #END}. */
  public int next(int number) {
    return next[number];
  }
}
