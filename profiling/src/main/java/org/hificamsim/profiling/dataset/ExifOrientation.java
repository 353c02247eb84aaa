package org.hificamsim.profiling.dataset;

import com.drew.imaging.ImageMetadataReader;
import com.drew.imaging.ImageProcessingException;
import com.drew.metadata.exif.ExifIFD0Directory;
import java.io.IOException;
import java.nio.file.Path;

/** How a photo is to be turned before it is shown (EXIF), which OpenCV does when it reads one. */
final class ExifOrientation {
  /** From here on width and height change places. */
  private static final int TURNED = 5;

  private ExifOrientation() {}

  /** Whether the photo is shown turned by a quarter. */
  static boolean isUpright(Path photo) {
    try {
      return ImageMetadataReader.readMetadata(photo.toFile())
          .getDirectoriesOfType(ExifIFD0Directory.class)
          .stream()
          .map(directory -> directory.getInteger(ExifIFD0Directory.TAG_ORIENTATION))
          .anyMatch(turn -> turn != null && turn >= TURNED && turn <= 8);
    } catch (ImageProcessingException | IOException e) {
      return false;
    }
  }
}
