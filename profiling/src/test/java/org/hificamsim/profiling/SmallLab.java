package org.hificamsim.profiling;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.DatasetReader;
import org.hificamsim.profiling.lab.LabSettings;
import org.hificamsim.profiling.lab.Laboratory;

/** A laboratory of a few dozen small photos, which is rendered once. */
public final class SmallLab {
  private static final Map<String, byte[]> FILES = new LinkedHashMap<>();

  private SmallLab() {}

  /** Returns settings with the default imperfections. */
  public static LabSettings settings(
      long seed, double scale, List<Double> focalLengths, List<Double> distances, int objects) {
    return new LabSettings(
        seed,
        scale,
        focalLengths,
        distances,
        objects,
        new LabSettings.Optics(5.6, 0.02, 1600, 0.5, 1),
        new LabSettings.Scene(4, 0.08, 0.08, 48));
  }

  /** Copies the laboratory into a folder. */
  public static synchronized Dataset render(Path folder) {
    try {
      if (FILES.isEmpty()) {
        photograph(folder);
      } else {
        for (Map.Entry<String, byte[]> file : FILES.entrySet()) {
          Path path = folder.resolve(file.getKey());
          Files.createDirectories(path.getParent());
          Files.write(path, file.getValue());
        }
      }
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
    return DatasetReader.read(folder).dataset().orElseThrow();
  }

  private static void photograph(Path folder) throws IOException {
    LabSettings settings =
        settings(1, 0.08, List.of(0.010, 0.024, 0.085), List.of(1.0, 2.0, 4.0, 8.0), 4);
    new Laboratory(settings).render(folder, 2, () -> {});
    try (Stream<Path> files = Files.walk(folder)) {
      for (Path file : files.filter(Files::isRegularFile).toList()) {
        FILES.put(folder.relativize(file).toString(), Files.readAllBytes(file));
      }
    }
  }
}
