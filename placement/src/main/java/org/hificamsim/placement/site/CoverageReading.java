package org.hificamsim.placement.site;

/** The meaning of a camera's covering a point. */
public enum CoverageReading {
  /** The point is in the fixed view that the camera got when it was mounted. */
  FIXED("by the fixed view of each camera"),

  /** The point is in any view to which the camera can turn and zoom, though not in all at once. */
  ANY("by some view of a camera that turns: what the network could see");

  private final String words;

  CoverageReading(String words) {
    this.words = words;
  }

  /** The reading in words, for people. */
  public String words() {
    return words;
  }
}
