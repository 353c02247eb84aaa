package org.hificamsim.profiling.fit;

/** A number of things, in words. */
public final class Counted {
  private Counted() {}

  /** Such as "1 photo" and "2 photos". */
  public static String of(long count, String thing) {
    return count + " " + thing + (count == 1 ? "" : thing.endsWith("s") ? "es" : "s");
  }
}
