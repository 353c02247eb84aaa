package org.hificamsim.profiling.detector;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.List;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.MatOfInt;
import org.opencv.core.MatOfRect;
import org.opencv.core.Rect;
import org.opencv.core.Size;
import org.opencv.objdetect.CascadeClassifier;

/**
 * What a cascade of Haar-like features was trained for (Viola and Jones, 2001). A box that n
 * neighbouring windows agree on scores n / (n + 3).
 */
final class HaarDetector implements BoxDetector {
  private static final int MIN_NEIGHBOURS = 3;

  /** Where Debian's opencv-data puts cascades. */
  private static final List<String> INSTALLED =
      List.of(
          "/usr/share/opencv4/haarcascades/haarcascade_%s.xml",
          "/usr/share/opencv4/lbpcascades/lbpcascade_%s.xml",
          "/usr/share/opencv/haarcascades/haarcascade_%s.xml");

  private final CascadeClassifier cascade;

  HaarDetector(Path file) {
    cascade = new CascadeClassifier(file.toString());
    if (cascade.empty()) {
      throw new InputException(file + ": no cascade, expected OpenCV's XML of one");
    }
  }

  /**
   * The cascade of this name: a file, or one that is installed.
   *
   * @throws InputException when there is none
   */
  static Path file(String name) {
    return Stream.concat(
            Stream.of(name), INSTALLED.stream().map(pattern -> pattern.formatted(name)))
        .map(Path::of)
        .filter(Files::isRegularFile)
        .findFirst()
        .orElseThrow(
            () ->
                new InputException(
                    "--detectors has 'haar:"
                        + name
                        + "', expected a cascade's XML file, or the name of one that Debian's"
                        + " opencv-data installs, such as frontalface_alt"));
  }

  @Override
  public List<Box> detect(Photograph photo) {
    try (Mats mats = new Mats()) {
      MatOfRect found = mats.own(new MatOfRect());
      MatOfInt neighbours = mats.own(new MatOfInt());
      cascade.detectMultiScale2(
          photo.grey(), found, neighbours, 1.1, MIN_NEIGHBOURS, 0, new Size(), new Size());
      return found.empty() ? List.of() : boxes(found.toArray(), neighbours.toArray());
    }
  }

  private static List<Box> boxes(Rect[] found, int[] neighbours) {
    List<Box> boxes = new ArrayList<>();
    for (int i = 0; i < found.length; i++) {
      double score = neighbours[i] / (neighbours[i] + (double) MIN_NEIGHBOURS);
      boxes.add(new Box(found[i].x, found[i].y, found[i].width, found[i].height, score));
    }
    return boxes;
  }
}
