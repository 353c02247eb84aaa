package org.hificamsim.core.detection;

/** The part of an upright target that a camera must see. */
public enum Seen {
  /** The point on the ground. */
  FEET,
  /** The highest point. */
  HEAD,
  /** The head, from the chin to the highest point. */
  FACE,
  /** The whole target, from the ground to its highest point. */
  WHOLE;

  /** The height of a head: people are seven and a half heads tall. */
  private static final double HEAD_SHARE = 1 / 7.5;

  /** The lowest height to be seen of a target with this height, in metres. */
  public double low(double height) {
    return switch (this) {
      case HEAD -> height;
      case FACE -> height - HEAD_SHARE * height;
      case FEET, WHOLE -> 0;
    };
  }

  /** The greatest height to be seen of a target with this height, in metres. */
  public double high(double height) {
    return this == FEET ? 0 : height;
  }
}
