package org.hificamsim.profiling.detector;

import java.util.ArrayList;
import java.util.List;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Mat;
import org.opencv.core.MatOfDouble;
import org.opencv.core.MatOfRect;
import org.opencv.core.Rect;
import org.opencv.objdetect.HOGDescriptor;

/**
 * People by histograms of oriented gradients (Dalal and Triggs, 2005) with the weights that OpenCV
 * has built in. A box scores the logistic function of its distance from the separating plane.
 */
final class HogDetector implements BoxDetector {
  private final HOGDescriptor people = new HOGDescriptor();

  HogDetector() {
    try (Mats mats = new Mats()) {
      people.setSVMDetector(mats.own(HOGDescriptor.getDefaultPeopleDetector()));
    }
  }

  @Override
  public List<Box> detect(Photograph photo) {
    Mat picture = photo.grey();
    if (picture.cols() < people.get_winSize().width
        || picture.rows() < people.get_winSize().height) {
      return List.of();
    }
    try (Mats mats = new Mats()) {
      MatOfRect found = mats.own(new MatOfRect());
      MatOfDouble weights = mats.own(new MatOfDouble());
      people.detectMultiScale(picture, found, weights);
      return found.empty() ? List.of() : boxes(found.toArray(), weights.toArray());
    }
  }

  private static List<Box> boxes(Rect[] found, double[] weights) {
    List<Box> boxes = new ArrayList<>();
    for (int i = 0; i < found.length; i++) {
      double score = 1 / (1 + StrictMath.exp(-weights[i]));
      boxes.add(new Box(found[i].x, found[i].y, found[i].width, found[i].height, score));
    }
    return boxes;
  }
}
