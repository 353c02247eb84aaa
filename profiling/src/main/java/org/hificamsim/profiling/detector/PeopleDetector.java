package org.hificamsim.profiling.detector;

import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Mat;
import org.opencv.core.MatOfDouble;
import org.opencv.core.MatOfRect;
import org.opencv.core.Rect;
import org.opencv.core.Size;
import org.opencv.objdetect.HOGDescriptor;

/**
 * People by histograms of oriented gradients (Dalal and Triggs, 2005) with the weights that OpenCV
 * has built in. A box scores the logistic function of its distance from the separating plane.
 */
final class PeopleDetector implements BoxDetector {
  private final HOGDescriptor people = new HOGDescriptor();

  PeopleDetector() {
    try (Mats mats = new Mats()) {
      people.setSVMDetector(mats.own(HOGDescriptor.getDefaultPeopleDetector()));
    }
  }

  @Override
  public String name() {
    return "hog";
  }

  @Override
  public List<Box> detect(Photograph photo) {
    Mat picture = photo.grey();
    Size window = people.get_winSize();
    if (picture.cols() < window.width || picture.rows() < window.height) {
      return List.of();
    }
    try (Mats mats = new Mats()) {
      MatOfRect found = mats.own(new MatOfRect());
      MatOfDouble weights = mats.own(new MatOfDouble());
      people.detectMultiScale(picture, found, weights);
      Rect[] boxes = found.toArray();
      return IntStream.range(0, boxes.length)
          .mapToObj(i -> box(boxes[i], 1 / (1 + StrictMath.exp(-weights.get(i, 0)[0]))))
          .toList();
    }
  }

  private static Box box(Rect rectangle, double score) {
    return new Box(rectangle.x, rectangle.y, rectangle.width, rectangle.height, score);
  }
}
