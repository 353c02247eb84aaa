package org.hificamsim.profiling.detector;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.core.InputException;

/**
 * Memory of both kinds: what is free, or what a detector takes for each pixel of a photo while it
 * looks at it, measured.
 *
 * @param nativeBytes outside Java's heap
 * @param heapBytes in Java's heap
 */
public record Memory(double nativeBytes, double heapBytes) {
  /** The share of what is free that is used, since needs are known roughly. */
  private static final double USED = 0.8;

  private static final Path LINUX = Path.of("/proc/meminfo");
  private static final double GIB = 1L << 30;

  /** What this machine has left now. */
  public static Memory free() {
    Runtime runtime = Runtime.getRuntime();
    double heap = runtime.maxMemory() - runtime.totalMemory() + (double) runtime.freeMemory();
    return new Memory(available() - heap, heap);
  }

  /** What both need who work one after the other. */
  Memory max(Memory other) {
    return new Memory(
        Math.max(nativeBytes, other.nativeBytes), Math.max(heapBytes, other.heapBytes));
  }

  /**
   * The number of threads for which this is enough, each with a photo.
   *
   * @param wanted at most
   * @param pixels of the largest photo
   * @param need for each pixel
   * @throws InputException when not even one fits
   */
  public int threads(int wanted, long pixels, Memory need) {
    double outside = USED * nativeBytes / (pixels * need.nativeBytes);
    double inside = USED * heapBytes / (pixels * need.heapBytes);
    double fit = Math.min(outside, inside);
    if (fit < 1) {
      throw InputException.of(
          "photos of %.1f megapixels need about %.1f GiB and %.1f GiB of Java's heap, expected"
              + " at most %.0f %% of the %.1f and %.1f GiB that are free. Maybe leave out"
              + " the detector sift, use smaller photos, or set HIFICAMSIM_OPTS=-Xmx for the"
              + " heap",
          pixels / 1e6,
          pixels * need.nativeBytes / GIB,
          pixels * need.heapBytes / GIB,
          100 * USED,
          nativeBytes / GIB,
          heapBytes / GIB);
    }
    return (int) Math.min(wanted, fit);
  }

  /** Bytes that can be had without swapping; in a container, no more than it may have. */
  private static double available() {
    OperatingSystemMXBean system = ManagementFactory.getPlatformMXBean(OperatingSystemMXBean.class);
    try {
      String line =
          Files.readAllLines(LINUX).stream()
              .filter(l -> l.startsWith("MemAvailable:"))
              .findFirst()
              .orElseThrow(IOException::new);
      double kibibytes = Double.parseDouble(line.replaceAll("\\D", ""));
      return Math.min((double) system.getTotalMemorySize(), 1024 * kibibytes);
    } catch (IOException e) {
      return (double) system.getFreeMemorySize();
    }
  }
}
