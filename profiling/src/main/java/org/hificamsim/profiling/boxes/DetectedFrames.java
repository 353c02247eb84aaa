package org.hificamsim.profiling.boxes;

import java.nio.file.Path;
import java.util.NavigableMap;
import org.hificamsim.core.InputException;
import org.hificamsim.core.Place;

/** Puts detections into the frames of a recording; those outside the labelled time are counted. */
final class DetectedFrames {
  private final NavigableMap<Long, FrameBoxes> frames;
  private final long first;
  private final long last;
  private int inside;
  private int outside;
  private Place firstOutside;
  private long frameOutside;

  DetectedFrames(NavigableMap<Long, FrameBoxes> frames, long first, long last) {
    this.frames = frames;
    this.first = first;
    this.last = last;
  }

  void add(Place place, long frame, Box box) {
    if (frame >= first && frame <= last) {
      frames.computeIfAbsent(frame, number -> new FrameBoxes()).detections().add(box);
      inside++;
    } else if (outside++ == 0) {
      firstOutside = place;
      frameOutside = frame;
    }
  }

  /** The number of detections before the first labelled frame or after the last. */
  int outside() {
    return outside;
  }

  /** Refuses detections of other frames than the labels, such as those of another recording. */
  void requireMatch(Path detections) {
    if (inside == 0 && outside == 0) {
      throw InputException.of("%s: no box, expected the boxes of a detector", detections);
    }
    if (outside > inside) {
      throw firstOutside.error(
          "frame is %s, and %s of %s boxes are in frames without labels, expected frames %s to %s,"
              + " as the labels have",
          frameOutside, outside, inside + outside, first, last);
    }
  }
}
