package org.hificamsim.profiling.detector;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.stream.IntStream;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.detector.BoxDetector.Box;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.CvException;
import org.opencv.core.Mat;
import org.opencv.core.MatOfDouble;
import org.opencv.core.MatOfInt;
import org.opencv.core.MatOfRect;
import org.opencv.core.Rect;
import org.opencv.core.Size;
import org.opencv.objdetect.CascadeClassifier;
import org.opencv.objdetect.HOGDescriptor;

/** The detectors of boxes that are a part of OpenCV. */
final class OpenCvBoxes {
  private static final int MIN_NEIGHBOURS = 3;

  /** Where Debian's opencv-data puts cascades. */
  private static final List<String> INSTALLED =
      List.of(
          "/usr/share/opencv4/haarcascades/haarcascade_%s.xml",
          "/usr/share/opencv4/lbpcascades/lbpcascade_%s.xml",
          "/usr/share/opencv/haarcascades/haarcascade_%s.xml");

  private OpenCvBoxes() {}

  /**
   * People by histograms of oriented gradients (Dalal and Triggs, 2005) with the weights that
   * OpenCV has built in. A box scores the logistic function of its distance from the separating
   * plane.
   */
  static BoxDetector people() {
    HOGDescriptor people = new HOGDescriptor();
    try (Mats mats = new Mats()) {
      people.setSVMDetector(mats.own(HOGDescriptor.getDefaultPeopleDetector()));
    }
    Size window = people.get_winSize();
    return photo -> {
      Mat picture = photo.grey();
      if (picture.cols() < window.width || picture.rows() < window.height) {
        return List.of();
      }
      try (Mats mats = new Mats()) {
        MatOfRect found = mats.own(new MatOfRect());
        MatOfDouble weights = mats.own(new MatOfDouble());
        people.detectMultiScale(picture, found, weights);
        return boxes(found, i -> 1 / (1 + StrictMath.exp(-weights.get(i, 0)[0])));
      }
    };
  }

  /**
   * What a cascade of Haar-like features was trained for (Viola and Jones, 2001). A box that n
   * neighbouring windows agree on scores n / (n + 3).
   */
  static BoxDetector cascade(Path file) {
    CascadeClassifier cascade = loaded(file);
    return photo -> {
      try (Mats mats = new Mats()) {
        MatOfRect found = mats.own(new MatOfRect());
        MatOfInt neighbours = mats.own(new MatOfInt());
        cascade.detectMultiScale2(
            photo.grey(), found, neighbours, 1.1, MIN_NEIGHBOURS, 0, new Size(), new Size());
        return boxes(
            found, i -> neighbours.get(i, 0)[0] / (neighbours.get(i, 0)[0] + MIN_NEIGHBOURS));
      }
    };
  }

  private static CascadeClassifier loaded(Path file) {
    String fault = file + ": no cascade, expected OpenCV's XML of one";
    try {
      CascadeClassifier cascade = new CascadeClassifier(file.toString());
      if (!cascade.empty()) {
        return cascade;
      }
    } catch (CvException e) {
      throw new InputException(fault, e);
    }
    throw new InputException(fault);
  }

  private static List<Box> boxes(MatOfRect found, IntToDoubleFunction score) {
    Rect[] boxes = found.toArray();
    return IntStream.range(0, boxes.length)
        .mapToObj(
            i ->
                new Box(
                    boxes[i].x,
                    boxes[i].y,
                    boxes[i].width,
                    boxes[i].height,
                    score.applyAsDouble(i)))
        .toList();
  }

  /**
   * The cascade of this name: a file, or one that is installed.
   *
   * @throws InputException when there is none
   */
  static Path cascadeFile(String name) {
    return Stream.concat(
            Stream.of(name), INSTALLED.stream().map(pattern -> pattern.formatted(name)))
        .map(Path::of)
        .filter(Files::isRegularFile)
        .findFirst()
        .orElseThrow(
            () ->
                InputException.of(
                    "--detectors has 'haar:%s', expected a cascade's XML file, or the name of one"
                        + " that Debian's opencv-data installs, such as frontalface_alt",
                    name));
  }
}
