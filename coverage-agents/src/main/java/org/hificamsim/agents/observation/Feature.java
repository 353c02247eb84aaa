package org.hificamsim.agents.observation;

/**
 * One number of an observation.
 *
 * @param low the least that it can be
 * @param high the most that it can be
 * @param meaning what it says, with its unit
 */
public record Feature(String name, float low, float high, String meaning) {
  static Feature share(String name, String meaning) {
    return new Feature(name, 0, 1, meaning);
  }

  static Feature signed(String name, String meaning) {
    return new Feature(name, -1, 1, meaning);
  }

  Feature of(String what, int number) {
    return new Feature(what + number + "_" + name, low, high, meaning);
  }
}
