package org.hificamsim.profiling.detector;

/**
 * The memory that a detector takes while it looks at a photo, measured.
 *
 * @param nativeBytes for each pixel, outside Java's heap
 * @param heapBytes for each pixel, in Java's heap
 */
public record MemoryNeed(double nativeBytes, double heapBytes) {
  /** What both need who work one after the other. */
  public MemoryNeed max(MemoryNeed other) {
    return new MemoryNeed(
        Math.max(nativeBytes, other.nativeBytes), Math.max(heapBytes, other.heapBytes));
  }
}
