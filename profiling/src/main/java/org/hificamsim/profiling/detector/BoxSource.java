package org.hificamsim.profiling.detector;

import java.util.List;
import java.util.Map;
import org.hificamsim.profiling.detector.BoxDetector.Box;

/** The score of the best box that lies on the object: one column. */
record BoxSource(String name, BoxDetector detector) implements ConfidenceSource {
  /**
   * How much a box and the object's patch must share. Less than the usual half: the window of the
   * people detector has a wide margin.
   */
  private static final double MIN_OVERLAP = 0.3;

  @Override
  public List<Map<String, Double>> confidences(
      Photograph photo, List<Subject> subjects, boolean shown) {
    List<Box> boxes = detector.detect(photo);
    return subjects.stream().map(subject -> Map.of(name, best(boxes, subject, shown))).toList();
  }

  private static double best(List<Box> boxes, Subject subject, boolean shown) {
    return boxes.stream()
        .filter(box -> !shown || box.overlap(subject.patch()) >= MIN_OVERLAP)
        .mapToDouble(Box::score)
        .max()
        .orElse(0);
  }
}
