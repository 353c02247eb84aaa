package org.hificamsim.profiling.detector;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.core.InputException;

/**
 * An amount of memory: the free memory, or the measured need of a detector per pixel of a photo.
 *
 * @param nativeBytes the memory outside Java's heap
 * @param heapBytes the memory in Java's heap
 */
public record Memory(double nativeBytes, double heapBytes) {
  /** The share of the free memory that is used, since needs are known only roughly. */
  private static final double USABLE_SHARE = 0.8;

  private static final Path MEMINFO = Path.of("/proc/meminfo");
  private static final double GIB = 1L << 30;

  /** Returns the memory that is free now. */
  public static Memory free() {
    Runtime runtime = Runtime.getRuntime();
    double heap = runtime.maxMemory() - runtime.totalMemory() + (double) runtime.freeMemory();
    return new Memory(available() - heap, heap);
  }

  /** Returns the need of two detectors that run one after the other. */
  Memory max(Memory other) {
    return new Memory(
        Math.max(nativeBytes, other.nativeBytes), Math.max(heapBytes, other.heapBytes));
  }

  /**
   * Returns how many threads, each with a photo, fit into this memory.
   *
   * @param maxThreads the upper limit of the result
   * @param pixels the number of pixels of the largest photo
   * @param need the memory needed for each pixel
   * @throws InputException when not even one photo fits
   */
  public int threads(int maxThreads, long pixels, Memory need) {
    double nativeFit = USABLE_SHARE * nativeBytes / (pixels * need.nativeBytes);
    double heapFit = USABLE_SHARE * heapBytes / (pixels * need.heapBytes);
    double fit = Math.min(nativeFit, heapFit);
    if (fit < 1) {
      throw InputException.of(
          "photos of %.1f megapixels need about %.1f GiB and %.1f GiB of Java's heap, expected"
              + " at most %.0f %% of the %.1f and %.1f GiB that are free. Maybe leave out"
              + " the detector sift, use smaller photos, or set HIFICAMSIM_OPTS=-Xmx for the"
              + " heap",
          pixels / 1e6,
          pixels * need.nativeBytes / GIB,
          pixels * need.heapBytes / GIB,
          100 * USABLE_SHARE,
          nativeBytes / GIB,
          heapBytes / GIB);
    }
    return (int) Math.min(maxThreads, fit);
  }

  /** Returns the bytes available without swapping, at most the limit of the container, if any. */
  private static double available() {
    OperatingSystemMXBean system = ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
    try {
      String line =
          Files.readAllLines(MEMINFO).stream()
              .filter(entry -> entry.startsWith("MemAvailable:"))
              .findFirst()
              .orElseThrow(IOException::new);
      double kibibytes = Double.parseDouble(line.replaceAll("\\D", ""));
      return Math.min((double) system.getTotalMemorySize(), 1024 * kibibytes);
    } catch (IOException e) {
      return (double) system.getFreeMemorySize();
    }
  }
}
