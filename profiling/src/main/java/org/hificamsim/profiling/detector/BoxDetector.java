package org.hificamsim.profiling.detector;

import java.util.List;
import org.hificamsim.profiling.dataset.Patch;

/**
 * A detector that knows what it looks for without a template: people, faces, a class of a network.
 * An instance serves one thread.
 */
interface BoxDetector {
  /** Every rectangle that it takes for what it looks for. */
  List<Box> detect(Photograph photo);

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
