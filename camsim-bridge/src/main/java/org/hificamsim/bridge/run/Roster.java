package org.hificamsim.bridge.run;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collection;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.function.Function;

/**
 * CamSim's cameras, or its objects, in the order in which they were first seen; each keeps its
 * number for the whole run. They are distinguished by identity: CamSim's own hash codes change as a
 * camera does.
 *
 * @param <T> what stands for one of them
 */
final class Roster<T> {
  private final IdentityHashMap<Object, Integer> numbers = new IdentityHashMap<>();
  private final List<T> all = new ArrayList<>();
  private final BitSet there = new BitSet();

  /**
   * Takes note of who is there now.
   *
   * @param newcomer makes what stands for one that is seen for the first time
   */
  void update(Collection<?> handles, Function<Object, T> newcomer) {
    there.clear();
    for (Object handle : handles) {
      int number = number(handle);
      if (number < 0) {
        number = all.size();
        numbers.put(handle, number);
        all.add(newcomer.apply(handle));
      }
      there.set(number);
    }
  }

  /** The number of one of CamSim's own; -1 when it has not been seen. */
  int number(Object handle) {
    return numbers.getOrDefault(handle, -1);
  }

  /** Whether it was there at the last update. */
  boolean isThere(int number) {
    return there.get(number);
  }

  /** What stands for this number. */
  T get(int number) {
    return all.get(number);
  }

  /** What stands for all that have been seen. */
  List<T> all() {
    return all;
  }
}
