package org.hificamsim.profiling.dataset;

import com.drew.imaging.ImageMetadataReader;
import com.drew.imaging.ImageProcessingException;
import com.drew.metadata.Directory;
import com.drew.metadata.exif.ExifIFD0Directory;
import com.drew.metadata.exif.ExifSubIFDDirectory;
import java.io.IOException;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import java.util.Objects;
import java.util.OptionalDouble;

/** What a camera wrote into a photo (EXIF). */
final class Exif {
  private static final double MILLIMETRE = 1e-3;

  /** From here on width and height change places. */
  private static final int TURNED = 5;

  private Exif() {}

  /** The focal length in metres, perhaps infinite; empty where the photo says nothing above 0. */
  static OptionalDouble focalLength(Path photo) {
    return directories(photo, ExifSubIFDDirectory.class).stream()
        .map(directory -> directory.getDoubleObject(ExifSubIFDDirectory.TAG_FOCAL_LENGTH))
        .filter(Objects::nonNull)
        .mapToDouble(millimetres -> millimetres * MILLIMETRE)
        .filter(metres -> metres > 0)
        .findFirst();
  }

  /** Whether the photo is shown turned by a quarter, as OpenCV does when it reads one. */
  static boolean isUpright(Path photo) {
    return directories(photo, ExifIFD0Directory.class).stream()
        .map(directory -> directory.getInteger(ExifIFD0Directory.TAG_ORIENTATION))
        .anyMatch(turn -> turn != null && turn >= TURNED && turn <= 8);
  }

  private static <D extends Directory> Collection<D> directories(Path photo, Class<D> kind) {
    try {
      return ImageMetadataReader.readMetadata(photo.toFile()).getDirectoriesOfType(kind);
    } catch (ImageProcessingException | IOException e) {
      return List.of();
    }
  }
}
