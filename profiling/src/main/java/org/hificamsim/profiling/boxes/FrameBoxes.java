package org.hificamsim.profiling.boxes;

import java.util.ArrayList;
import java.util.List;

/**
 * The labelled boxes and the detected boxes of one frame.
 *
 * @param labels the labelled boxes, in the order of the file
 * @param detections the detected boxes, in the order of the file
 */
record FrameBoxes(List<LabelledBox> labels, List<Box> detections) {
  FrameBoxes() {
    this(new ArrayList<>(), new ArrayList<>());
  }
}
