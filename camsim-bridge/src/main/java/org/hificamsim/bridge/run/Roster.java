package org.hificamsim.bridge.run;

import java.util.ArrayList;
import java.util.BitSet;
import java.util.Collection;
import java.util.IdentityHashMap;
import java.util.List;
import java.util.function.Function;

/**
 * Numbers the cameras or objects of CamSim in the order in which they first appear. It tells them
 * apart by identity, since their hash codes change with their state.
 *
 * @param <T> our representation of a camera or object
 */
final class Roster<T> {
  private final IdentityHashMap<Object, Integer> numbers = new IdentityHashMap<>();
  private final List<T> all = new ArrayList<>();
  private final BitSet present = new BitSet();

  /**
   * Updates which cameras or objects are present.
   *
   * @param creator creates the representation of a new camera or object
   */
  void update(Collection<?> handles, Function<Object, T> creator) {
    present.clear();
    for (Object handle : handles) {
      int number = number(handle);
      if (number < 0) {
        number = all.size();
        numbers.put(handle, number);
        all.add(creator.apply(handle));
      }
      present.set(number);
    }
  }

  /** The number of a camera or object of CamSim; -1 if it has never appeared. */
  int number(Object handle) {
    return numbers.getOrDefault(handle, -1);
  }

  /** Returns whether the camera or object was present at the last update. */
  boolean isPresent(int number) {
    return present.get(number);
  }

  /** Returns the representation with a number. */
  T get(int number) {
    return all.get(number);
  }

  /** The representations of all that have ever appeared. */
  List<T> all() {
    return all;
  }
}
