package org.hificamsim.profiling.measure;

import java.nio.file.Path;
import java.util.Optional;
import org.hificamsim.core.InputException;
import org.hificamsim.profiling.dataset.LabelledPhoto;
import org.hificamsim.profiling.dataset.PhotoCamera;
import org.hificamsim.profiling.detector.Photograph;
import org.opencv.core.Core;

/** The ground truth: the share of the image that is the object's. */
record PipCount(PhotoCamera camera, PipReading reading) {
  double of(LabelledPhoto sample) {
    Optional<Path> mask = sample.mask();
    long set =
        reading == PipReading.RECTANGLE || mask.isEmpty()
            ? sample.patch().area()
            : pixels(mask.get());
    return set / (double) camera.pixels();
  }

  private static long pixels(Path mask) {
    try (Photograph picture = new Photograph(mask)) {
      int set = Core.countNonZero(picture.grey());
      if (set == 0) {
        throw new InputException(mask + ": the mask is empty, expected the object's pixels");
      }
      return set;
    }
  }
}
