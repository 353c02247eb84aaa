package org.hificamsim.profiling.boxes;

import java.util.ArrayList;
import java.util.List;

/**
 * One frame of a recording: what is labelled in it, and what the detector found.
 *
 * @param labels in the order of the file
 * @param detections in the order of the file
 */
record FrameBoxes(List<LabelledBox> labels, List<Box> detections) {
  FrameBoxes() {
    this(new ArrayList<>(), new ArrayList<>());
  }
}
