package org.hificamsim.profiling.detector;

import java.util.List;
import java.util.Map;
import org.hificamsim.profiling.dataset.Patch;

/**
 * A detector that knows what it looks for without a template: people, faces, a class of a network.
 * An instance serves one thread.
 */
interface BoxDetector extends ConfidenceSource {
  /**
   * How much a box and the object's patch must share. Less than the usual half: the window of the
   * people detector has a wide margin.
   */
  double MIN_OVERLAP = 0.3;

  /** Every rectangle that it takes for what it looks for. */
  List<Box> detect(Photograph photo);

  /** The score of the best box that lies on the object: one column. */
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
   * A rectangle of a photo in which a detector sees what it looks for; pixels.
   *
   * @param score how sure it is, (0, 1]
   */
  record Box(double x, double y, double width, double height, double score) {
    /** The share of what both cover together that both cover (intersection over union). */
    double overlap(Patch patch) {
      double across = Math.min(x + width, patch.x() + patch.width()) - Math.max(x, patch.x());
      double down = Math.min(y + height, patch.y() + patch.height()) - Math.max(y, patch.y());
      double both = Math.max(0, across) * Math.max(0, down);
      return both / (width * height + patch.area() - both);
    }
  }
}
