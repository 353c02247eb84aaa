package org.hificamsim.profiling.boxes;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.NavigableMap;
import java.util.Optional;
import java.util.TreeMap;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.check.Calibration.Size;

/**
 * A labelled recording with the boxes of a detector.
 *
 * @param name the name in tables
 * @param picture the size of the picture, if it is known
 * @param frames the frames by number, from the first that has a label to the last
 * @param outside the number of detections before the first labelled frame or after the last
 */
public record BoxRecording(
    String name, Optional<Size> picture, NavigableMap<Long, FrameBoxes> frames, int outside) {
  /**
   * Settings for reading files.
   *
   * @param picture the size of the picture, which YOLO's files need
   * @param type the class of the labels that count; empty for people
   * @param leastScore the least score of the detections that are read, in [0, 1]
   */
  public record Reading(Optional<Size> picture, Optional<String> type, double leastScore) {}

  /**
   * Reads labels and detections, each in MOTChallenge's format, in COCO's (a name that ends in
   * {@code .json}) or in YOLO's (a folder).
   *
   * @throws InputException with line and column, if a file is wrong or the frames do not match
   */
  public static BoxRecording read(Path labels, Path detections, Reading reading) {
    BoxFile labelFile = BoxFile.of(labels, reading);
    NavigableMap<Long, FrameBoxes> frames = new TreeMap<>();
    labelFile.labels((frame, label) -> frameAt(frames, frame).labels().add(label));
    if (frames.values().stream()
        .flatMap(frame -> frame.labels().stream())
        .noneMatch(LabelledBox::counted)) {
      throw InputException.of("%s: nobody is labelled, expected a box at least", labels);
    }
    long first = frames.firstKey();
    long last = frames.lastKey();
    DetectedFrames detected = new DetectedFrames(frames, first, last);
    BoxFile.of(detections, reading).detections(labelFile, detected);
    detected.requireMatch(detections);
    return new BoxRecording(name(labels), labelFile.picture(), frames, detected.outside());
  }

  private static FrameBoxes frameAt(NavigableMap<Long, FrameBoxes> frames, long frame) {
    return frames.computeIfAbsent(frame, number -> new FrameBoxes());
  }

  /** The file's name without its endings; gt.txt is named by the folder of its sequence. */
  private static String name(Path labels) {
    Path path = labels.toAbsolutePath().normalize();
    Path parent = path.getParent();
    String name = path.getFileName().toString().replaceFirst("\\.(txt|json|csv)(\\.gz)?$", "");
    boolean isSequence =
        name.toLowerCase(Locale.ROOT).equals("gt")
            && parent != null
            && parent.endsWith("gt")
            && Files.isRegularFile(path)
            && parent.getParent() != null
            && parent.getParent().getFileName() != null;
    return isSequence
        ? parent.getParent().getFileName().toString()
        : name.replaceFirst("[._-](gt|labels?|annotations)$", "");
  }
}
