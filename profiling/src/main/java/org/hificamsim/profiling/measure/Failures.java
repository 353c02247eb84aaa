package org.hificamsim.profiling.measure;

import java.nio.file.Path;
import java.util.function.Supplier;
import org.hificamsim.core.InputException;
import org.opencv.core.CvException;

/** Work on a picture whose failure names the picture. */
final class Failures {
  private Failures() {}

  /**
   * Does the work.
   *
   * @throws InputException in one line with the file and the detector, where OpenCV or the memory
   *     gives out
   */
  static <T> T named(Path file, String detector, Supplier<T> work) {
    try {
      return work.get();
    } catch (CvException | OutOfMemoryError e) {
      String reason = String.valueOf(e.getMessage()).lines().findFirst().orElse("").strip();
      throw new InputException(
          "%s: %s fails, expected a picture that it can take (%s). Maybe there is too little memory: use smaller photos, fewer --threads or other --detectors"
              .formatted(file, detector, reason),
          e);
    }
  }
}
