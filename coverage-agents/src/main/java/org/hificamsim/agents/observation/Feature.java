package org.hificamsim.agents.observation;

/**
 * One number of an observation.
 *
 * @param low the least possible value
 * @param high the greatest possible value
 * @param meaning what the number says, with its unit
 */
public record Feature(String name, float low, float high, String meaning) {
  /** Returns a feature from 0 to 1. */
  static Feature share(String name, String meaning) {
    return new Feature(name, 0, 1, meaning);
  }

  /** Returns a feature from -1 to 1. */
  static Feature signed(String name, String meaning) {
    return new Feature(name, -1, 1, meaning);
  }

  /** Returns the feature of a numbered neighbour, target or view. */
  Feature numbered(String owner, int number) {
    return new Feature(owner + number + "_" + name, low, high, meaning);
  }
}
