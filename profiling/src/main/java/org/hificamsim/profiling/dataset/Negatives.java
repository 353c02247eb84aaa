package org.hificamsim.profiling.dataset;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;

/** The pictures of a folder, which the camera took where there was none of the objects. */
record Negatives(Path folder, PhotoCamera camera) {
  /** Their files in the order of their names; adds a line for each that is wrong. */
  List<Path> read(List<String> problems) {
    List<Path> files = new ArrayList<>();
    for (Path file : pictures(problems)) {
      try {
        ImageHeader header = ImageHeader.read(file);
        if (!camera.takes(header.width(), header.height())) {
          throw new IOException(
              "is %s x %s pixels, expected %s x %s as camera.json says, or upright"
                  .formatted(header.width(), header.height(), camera.width(), camera.height()));
        }
        files.add(file);
      } catch (IOException | RuntimeException e) {
        problems.add(file + ": " + e.getMessage());
      }
    }
    return files;
  }

  private List<Path> pictures(List<String> problems) {
    if (!Files.isDirectory(folder)) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(folder)) {
      return files.filter(Negatives::isPicture).sorted().toList();
    } catch (IOException e) {
      problems.add(folder + ": cannot be read, expected a folder of photos: " + e.getMessage());
      return List.of();
    }
  }

  private static boolean isPicture(Path file) {
    return file.getFileName()
        .toString()
        .toLowerCase(Locale.ROOT)
        .matches("[^.].*\\.(png|jpg|jpeg)");
  }
}
