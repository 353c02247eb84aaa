package org.hificamsim.profiling.measure;

import com.sun.management.OperatingSystemMXBean;
import java.io.IOException;
import java.lang.management.ManagementFactory;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.detector.MemoryNeed;

/**
 * How many photos may be in memory at once.
 *
 * @param nativeBytes free outside Java's heap
 * @param heapBytes free in Java's heap
 */
record MemoryBudget(double nativeBytes, double heapBytes) {
  /** The share of what is free that is used, since needs are known roughly. */
  private static final double USED = 0.8;

  private static final Path LINUX = Path.of("/proc/meminfo");
  private static final double GIB = 1L << 30;

  /** What this machine has left now. */
  static MemoryBudget now() {
    Runtime runtime = Runtime.getRuntime();
    double heap = runtime.maxMemory() - runtime.totalMemory() + (double) runtime.freeMemory();
    return new MemoryBudget(available() - heap, heap);
  }

  /**
   * The number of threads that fit.
   *
   * @param wanted at most
   * @param pixels of the largest photo
   * @throws InputException when not even one fits
   */
  int threads(int wanted, long pixels, MemoryNeed memoryNeed) {
    double outside = USED * nativeBytes / (pixels * memoryNeed.nativeBytes());
    double inside = USED * heapBytes / (pixels * memoryNeed.heapBytes());
    double fit = Math.min(outside, inside);
    if (fit < 1) {
      throw tooSmall(pixels, memoryNeed);
    }
    return (int) Math.min(wanted, fit);
  }

  private InputException tooSmall(long pixels, MemoryNeed memoryNeed) {
    return new InputException(
        String.format(
            Locale.ROOT,
            "photos of %.1f megapixels need about %.1f GiB and %.1f GiB of Java's heap, expected at"
                + " most %.0f %% of the %.1f and %.1f GiB that are free. Maybe leave out"
                + " --detectors sift, use smaller photos, or set HIFICAMSIM_OPTS=-Xmx for the heap",
            pixels / 1e6,
            pixels * memoryNeed.nativeBytes() / GIB,
            pixels * memoryNeed.heapBytes() / GIB,
            100 * USED,
            nativeBytes / GIB,
            heapBytes / GIB));
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
