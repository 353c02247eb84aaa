package org.hificamsim.placement.site;

/** The condition under which a camera covers a point. */
public enum CoverageReading {
  /** The point is in the view in which the camera is mounted. */
  FIXED("by the fixed view of each camera"),

  /**
   * The point is in any view to which the camera can turn and zoom. The camera has one view at a
   * time, so it may not see all its points at once.
   */
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
