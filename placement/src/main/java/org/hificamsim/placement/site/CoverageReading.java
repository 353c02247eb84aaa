package org.hificamsim.placement.site;

/** What it means that a camera covers a place. */
public enum CoverageReading {
  /** The fixed view that it was given when it was mounted has it. */
  FIXED("by the fixed view of each camera"),
  /** Some view that it can turn and zoom to has it: what the network could see, not at once. */
  ANY("by some view of a camera that turns: what the network could see");

  private final String words;

  CoverageReading(String words) {
    this.words = words;
  }

  /** The reading in words. */
  public String words() {
    return words;
  }
}
