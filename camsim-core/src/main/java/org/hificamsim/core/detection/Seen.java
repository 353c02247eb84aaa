package org.hificamsim.core.detection;

/** What of an upright target a camera has to see. */
public enum Seen {
  /** The point on the ground. */
  FEET,
  /** The highest point. */
  HEAD,
  /** All from the ground to the highest point. */
  WHOLE;

  /** The least height that has to be seen of a target of a height, metres. */
  public double low(double height) {
    return this == HEAD ? height : 0;
  }

  /** The greatest. */
  public double high(double height) {
    return this == FEET ? 0 : height;
  }
}
