package org.hificamsim.profiling.detector;

import java.util.List;
import java.util.Map;
import org.hificamsim.profiling.dataset.Patch;

/** A detector that computes one or more columns of confidences. Not thread-safe. */
public interface ConfidenceSource {
  /** Returns the name of its first column, by which error messages call it. */
  String name();

  /**
   * Computes the confidences for some subjects in a photo.
   *
   * @param shown whether the photo shows the subjects; if not, their patches only give their sizes,
   *     and false detections anywhere count
   * @return the confidences of each subject, by column; each in [0, 1]
   */
  List<Map<String, Double>> confidences(Photograph photo, List<Subject> subjects, boolean shown);

  /**
   * An object that a detector looks for in a photo.
   *
   * @param object the name of the object
   * @param patch the rectangle around it
   */
  record Subject(String object, Patch patch) {}
}
