package org.hificamsim.network.agent;

import java.util.Arrays;

/**
 * A list of numbers in the order in which a Java hash map iterates over their keys: by bucket, and
 * inside a bucket by insertion (behaviour 4.4). It allocates nothing while it does not grow, and is
 * read like an array: a hash map with an iterator makes a step a fifth slower.
 *
 * <p>From a capacity of 64 on, a hash map orders nine and more keys of one bucket by their
 * addresses; here they keep the order of insertion.
 */
final class HashOrder {
  private static final int FIRST_CAPACITY = 16;
  private static final int MAX_BUCKET = 8;
  private static final int MIN_TREE_CAPACITY = 64;

  private int[] items = new int[FIRST_CAPACITY];
  private int[] hashes = new int[FIRST_CAPACITY];
  private int size;
  private int capacity = FIRST_CAPACITY;

  /**
   * Adds an item whose key is not yet in the list.
   *
   * @param hash the hash code of its key
   */
  void add(int item, int hash) {
    append(item, hash ^ (hash >>> 16)); // the hash as Java spreads it
  }

  private void append(int item, int hash) {
    if (size == items.length) {
      items = Arrays.copyOf(items, 2 * size);
      hashes = Arrays.copyOf(hashes, 2 * size);
    }
    insert(size++, item, hash);
    if (size > MAX_BUCKET && capacity < MIN_TREE_CAPACITY && bucketSize(hash) > MAX_BUCKET) {
      grow();
    }
    if (size > capacity * 3 / 4) {
      grow();
    }
  }

  /** Inserts an item after the last one of its bucket, among the items before an end. */
  private void insert(int end, int item, int hash) {
    int index = end;
    for (; index > 0 && bucket(hashes[index - 1]) > bucket(hash); index--) {
      items[index] = items[index - 1];
      hashes[index] = hashes[index - 1];
    }
    items[index] = item;
    hashes[index] = hash;
  }

  private int bucket(int hash) {
    return hash & (capacity - 1);
  }

  private int bucketSize(int hash) {
    int count = 0;
    for (int i = 0; i < size; i++) {
      count += bucket(hashes[i]) == bucket(hash) ? 1 : 0;
    }
    return count;
  }

  private void grow() {
    capacity *= 2;
    for (int i = 1; i < size; i++) {
      insert(i, items[i], hashes[i]);
    }
  }

  /** Replaces an item by another with an equal key. */
  void replace(int index, int item) {
    items[index] = item;
  }

  void removeAt(int index) {
    size--;
    System.arraycopy(items, index + 1, items, index, size - index);
    System.arraycopy(hashes, index + 1, hashes, index, size - index);
  }

  int get(int index) {
    return items[index];
  }

  int size() {
    return size;
  }

  /** Empties the list, and starts again with the first capacity. */
  void clear() {
    size = 0;
    capacity = FIRST_CAPACITY;
  }

  /** Whether a copy of the hash map has the same order, because neither has grown. */
  boolean isOrderOfCopy() {
    return capacity == FIRST_CAPACITY;
  }

  /**
   * Refills this list with the items of another one, in its order, as Java copies a hash map; the
   * order may change.
   */
  void refillFrom(HashOrder other) {
    clear();
    for (int i = 0; i < other.size; i++) {
      append(other.items[i], other.hashes[i]);
    }
  }
}
