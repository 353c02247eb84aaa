package org.hificamsim.profiling.detector;

import java.util.List;
import java.util.Map;
import org.hificamsim.profiling.dataset.Patch;

/**
 * A detector that finds objects without a template, such as a class of a network. Not thread-safe.
 */
interface BoxDetector extends ConfidenceSource {
  /**
   * The least overlap (intersection over union) of a box and the object's patch. It is below the
   * usual one half because boxes may have a wide margin.
   */
  double MIN_OVERLAP = 0.3;

  /** Returns the rectangles in which the detector finds its objects. */
  List<Box> detect(Photograph photo);

  /** Returns one column: the score of the best box that lies on the object. */
  @Override
  default List<Map<String, Double>> confidences(
      Photograph photo, List<Subject> subjects, boolean shown) {
    List<Box> boxes = detect(photo);
    return subjects.stream().map(subject -> Map.of(name(), best(boxes, subject, shown))).toList();
  }

  private static double best(List<Box> boxes, Subject subject, boolean shown) {
    return boxes.stream()
        .filter(box -> !shown || box.overlap(subject.patch()) >= MIN_OVERLAP)
        .mapToDouble(Box::score)
        .max()
        .orElse(0);
  }

  /**
   * A rectangle of a photo in which a detector finds an object, in pixels.
   *
   * @param score the confidence of the detector, (0, 1]
   */
  record Box(double x, double y, double width, double height, double score) {
    /** Returns the intersection of the box and a patch, divided by their union. */
    double overlap(Patch patch) {
      double commonWidth = Math.min(x + width, patch.x() + patch.width()) - Math.max(x, patch.x());
      double commonHeight =
          Math.min(y + height, patch.y() + patch.height()) - Math.max(y, patch.y());
      double intersection = Math.max(0, commonWidth) * Math.max(0, commonHeight);
      return intersection / (width * height + patch.area() - intersection);
    }
  }
}
