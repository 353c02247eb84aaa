package org.hificamsim.network.agent;

import java.util.Arrays;

/**
 * A list of numbers in the order in which a Java hash map would iterate over their keys: by bucket,
 * and inside a bucket by insertion (behaviour 4.4). Nothing is allocated while it does not grow.
 *
 * <p>Eight and more keys of one bucket, where a hash map keeps a tree, are treated like fewer.
 */
public final class HashOrder {
  private static final int FIRST_CAPACITY = 16;

  private int[] items = new int[FIRST_CAPACITY];
  private int[] hashes = new int[FIRST_CAPACITY];
  private int size;
  private int capacity = FIRST_CAPACITY;

  /** Java's spreading of a key's hash code before the bucket is taken from its low bits. */
  private static int spread(int hash) {
    return hash ^ (hash >>> 16);
  }

  /** The hash code of a one-element list of this number, CamSim's key for a target. */
  static int hashOfFeatures(double features) {
    return 31 + Double.hashCode(features);
  }

  /**
   * Adds an item that is not in the list.
   *
   * @param hash its key's hash code
   */
  void add(int item, int hash) {
    append(item, spread(hash));
  }

  private void append(int item, int spreadHash) {
    if (size == items.length) {
      items = Arrays.copyOf(items, 2 * size);
      hashes = Arrays.copyOf(hashes, 2 * size);
    }
    insert(size++, item, spreadHash);
    if (size > capacity * 3 / 4) {
      capacity *= 2;
      redistribute();
    }
  }

  /** Moves what lies behind its place up, and puts the item there. */
  private void insert(int end, int item, int hash) {
    int bucket = hash & (capacity - 1);
    int place = end;
    while (place > 0 && (hashes[place - 1] & (capacity - 1)) > bucket) {
      items[place] = items[place - 1];
      hashes[place] = hashes[place - 1];
      place--;
    }
    items[place] = item;
    hashes[place] = hash;
  }

  private void redistribute() {
    for (int i = 1; i < size; i++) {
      insert(i, items[i], hashes[i]);
    }
  }

  /** Puts another item of the same key in the place of the one at {@code index}. */
  void replace(int index, int item) {
    items[index] = item;
  }

  /** Removes the item at {@code index}. */
  void removeAt(int index) {
    size--;
    System.arraycopy(items, index + 1, items, index, size - index);
    System.arraycopy(hashes, index + 1, hashes, index, size - index);
  }

  /** The item at {@code index}. */
  public int get(int index) {
    return items[index];
  }

  /** The number of items. */
  public int size() {
    return size;
  }

  /** Empties the list, as if it were new. */
  void reset() {
    size = 0;
    capacity = FIRST_CAPACITY;
  }

  /** Makes the list a copy of {@code other}, filled from the first capacity on in its order. */
  public void copy(HashOrder other) {
    reset();
    for (int i = 0; i < other.size; i++) {
      append(other.items[i], other.hashes[i]);
    }
  }
}
