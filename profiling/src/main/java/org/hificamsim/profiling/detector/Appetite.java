package org.hificamsim.profiling.detector;

/**
 * The memory that a detector takes while it looks at a photo, measured.
 *
 * @param nativeBytes for each pixel, outside Java's heap
 * @param heapBytes for each pixel, in Java's heap
 */
public record Appetite(double nativeBytes, double heapBytes) {
  /** What both need who work one after the other. */
  public Appetite max(Appetite other) {
    return new Appetite(
        Math.max(nativeBytes, other.nativeBytes), Math.max(heapBytes, other.heapBytes));
  }
}
