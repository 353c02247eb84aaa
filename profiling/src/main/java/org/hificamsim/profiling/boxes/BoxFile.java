package org.hificamsim.profiling.boxes;

import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Locale;
import java.util.Optional;
import org.hificamsim.core.Place;
import org.hificamsim.profiling.check.Calibration.Size;

/** A file, or a folder, of boxes in one of the formats. */
interface BoxFile {
  /** Receives labels, frame by frame or in any order. */
  @FunctionalInterface
  interface LabelListener {
    void label(long frame, LabelledBox label);
  }

  /** Reads the labels. */
  void labels(LabelListener listener);

  /**
   * Reads the boxes of a detector.
   *
   * @param labels the file of the labels, which may name classes
   */
  void detections(BoxFile labels, DetectedFrames detected);

  /** The size of the picture, if the settings or the file name it; asked after the labels. */
  Optional<Size> picture();

  /** Returns the reader of a file by its name. */
  static BoxFile of(Path file, BoxRecording.Reading reading) {
    if (Files.isDirectory(file)) {
      return new YoloFolder(file, reading);
    }
    String name = file.toString().toLowerCase(Locale.ROOT);
    return name.endsWith(".json") || name.endsWith(".json.gz")
        ? new CocoFile(file, reading)
        : new MotBoxFile(file, reading);
  }

  /** Returns a box, whose width and height must be above 0. */
  static Box box(Place place, double left, double top, double width, double height) {
    if (!(width > 0 && height > 0)) {
      throw place.error(
          "the box is %s x %s pixels, expected a width and a height above 0", width, height);
    }
    return new Box(left, top, width, height);
  }

  /** Returns a score, which must be in [0, 1]. */
  static double score(Place place, double score) {
    if (!(score >= 0 && score <= 1)) {
      throw place.invalid("score", String.valueOf(score), "a number from 0 to 1");
    }
    return score;
  }
}
