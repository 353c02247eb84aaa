package org.hificamsim.profiling.dataset;

import com.drew.imaging.ImageMetadataReader;
import com.drew.imaging.ImageProcessingException;
import com.drew.metadata.exif.ExifSubIFDDirectory;
import java.io.IOException;
import java.nio.file.Path;
import java.util.OptionalDouble;

/** The focal length that a camera wrote into a photo (EXIF). */
final class ExifFocalLength {
  private static final double MILLIMETRE = 1e-3;

  private ExifFocalLength() {}

  /** Metres, as the photo has it: perhaps infinite; empty where it says nothing above 0. */
  static OptionalDouble of(Path photo) {
    try {
      for (ExifSubIFDDirectory directory :
          ImageMetadataReader.readMetadata(photo.toFile())
              .getDirectoriesOfType(ExifSubIFDDirectory.class)) {
        Double millimetres = directory.getDoubleObject(ExifSubIFDDirectory.TAG_FOCAL_LENGTH);
        if (millimetres != null && millimetres > 0) {
          return OptionalDouble.of(millimetres * MILLIMETRE);
        }
      }
      return OptionalDouble.empty();
    } catch (ImageProcessingException | IOException e) {
      return OptionalDouble.empty();
    }
  }
}
