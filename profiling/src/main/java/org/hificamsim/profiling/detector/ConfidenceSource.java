package org.hificamsim.profiling.detector;

import java.util.List;
import java.util.Map;
import org.hificamsim.profiling.dataset.Patch;

/**
 * A detector at work, which makes one or more columns of confidences. An instance serves one
 * thread.
 */
public interface ConfidenceSource {
  /** What it is called when it fails: the name of its first column. */
  String name();

  /**
   * Looks at a photo once, for some subjects.
   *
   * @param shown whether the photo has the subjects; where it has none of them, their patches say
   *     how large they would be, and what is taken for them counts
   * @return the confidences of each subject, by column; each in [0, 1]
   */
  List<Map<String, Double>> confidences(Photograph photo, List<Subject> subjects, boolean shown);

  /**
   * What a detector is asked for in a photo.
   *
   * @param object by its name
   * @param patch where it is
   */
  record Subject(String object, Patch patch) {}
}
