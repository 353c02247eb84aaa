package org.hificamsim.core.detection;

/** The part of an upright target that a camera must see. */
public enum Seen {
  /** The point on the ground. */
  FEET,
  /** The highest point. */
  HEAD,
  /** Everything from the ground to the highest point. */
  WHOLE;

  /** The lowest height to be seen of a target with this height, metres. */
  public double low(double height) {
    return this == HEAD ? height : 0;
  }

  /** The greatest height to be seen of a target with this height, metres. */
  public double high(double height) {
    return this == FEET ? 0 : height;
  }
}
