package org.hificamsim.cli;

import java.nio.file.Path;
import java.util.OptionalDouble;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Ranges;
import picocli.CommandLine.Option;

/** The options for a scenario that is made of files: name, field and draft cameras. */
final class SiteOptions {
  private static final double MAX_METRES = 1e9;
  private static final int MAX_CAMERAS = 1000;

  @Option(names = "--name", paramLabel = "NAME")
  private String name;

  @Option(names = "--cameras", paramLabel = "N")
  private int cameras;

  @Option(names = "--margin", paramLabel = "M")
  private Double margin;

  /** The name of the scenario: the value of the option, or else the name of a file. */
  String name(Path file) {
    String fileName = file.getFileName().toString().replaceFirst("(?i)\\.gz$", "");
    String requested = name != null ? name : fileName.replaceFirst("\\.[^.]*$", "");
    String safe = safe(requested);
    if (safe.isEmpty() || safe.startsWith(".") || (name != null && !safe.equals(requested))) {
      throw InputException.of(
          "--name is '%s', expected letters, digits and any of _.+- of them", requested);
    }
    return safe;
  }

  /** Returns a name in which characters that a file's name may not have are hyphens. */
  static String safe(String name) {
    return name.replaceAll("[^\\p{L}\\p{M}\\p{N}_.+-]", "-");
  }

  /** The number of draft cameras, which is at least {@code least}. */
  int cameras(int least) {
    return Numbers.inRange("--cameras", cameras, least, MAX_CAMERAS);
  }

  OptionalDouble margin() {
    return margin == null
        ? OptionalDouble.empty()
        : OptionalDouble.of(Ranges.within("--margin", margin, 0, MAX_METRES));
  }
}
