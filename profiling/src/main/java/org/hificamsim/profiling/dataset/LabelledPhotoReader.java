package org.hificamsim.profiling.dataset;

import java.io.IOException;
import java.nio.file.Path;
import java.util.List;
import java.util.Optional;
import java.util.function.Supplier;
import org.hificamsim.core.InputException;
import org.hificamsim.data.CsvRow;

/** Checks the cells of one row and turns them into a {@link LabelledPhoto}. */
final class LabelledPhotoReader {
  static final List<String> PATCH = List.of("patch_x", "patch_y", "patch_width", "patch_height");

  /** A picture file with its header. */
  private record Picture(Path file, ImageHeader header) {}

  private static final double MAX_SIZE = 1e3;
  private static final double MAX_DISTANCE = 1e5;
  private static final double MAX_FOCAL_LENGTH = 10;
  private static final double MAX_PIXELS = 1e6;

  private final Path folder;
  private final PhotoCamera camera;
  private final CocoPatches coco;
  private final CsvRow row;
  private final List<String> problems;

  LabelledPhotoReader(
      Path folder, PhotoCamera camera, CocoPatches coco, CsvRow row, List<String> problems) {
    this.folder = folder;
    this.camera = camera;
    this.coco = coco;
    this.row = row;
    this.problems = problems;
  }

  /** Returns the photo of the row; empty if the row has problems, which are then reported. */
  Optional<LabelledPhoto> read() {
    int problemsBefore = problems.size();
    Picture image = orReport(() -> picture("image"));
    String object = orReport(this::object);
    Double size = orReport(() -> length("size_m", MAX_SIZE));
    Double distance = orReport(() -> length("distance_m", MAX_DISTANCE));
    Double focalLength = image == null ? null : orReport(() -> focalLength(image.file()));
    ImageHeader frame =
        image == null ? new ImageHeader(camera.width(), camera.height()) : image.header();
    Patch patch = object == null ? null : orReport(() -> patch(object, frame));
    Optional<Path> mask = Optional.ofNullable(orReport(() -> mask(frame)));
    return problems.size() > problemsBefore
        ? Optional.empty()
        : Optional.of(
            new LabelledPhoto(
                row.text("image"), image.file(), object, size, distance, focalLength, patch, mask));
  }

  private <T> T orReport(Supplier<T> part) {
    try {
      return part.get();
    } catch (InputException e) {
      problems.add(e.getMessage());
      return null;
    }
  }

  /** Returns the mask, which must be as large as its picture; null if there is none. */
  private Path mask(ImageHeader image) {
    if (!row.has("mask") || row.text("mask").isEmpty()) {
      return null;
    }
    Picture mask = picture("mask");
    if (!mask.header().equals(image)) {
      throw row.invalid("mask", "a picture that is as wide and high as its image");
    }
    return mask.file();
  }

  /** Reads a picture in the folder, which must have the camera's size. */
  private Picture picture(String column) {
    Path file = fileInFolder(column);
    ImageHeader header;
    try {
      header = ImageHeader.read(file);
    } catch (IOException | RuntimeException e) {
      throw row.invalid(column, "a whole PNG or JPEG in the folder (" + e.getMessage() + ")");
    }
    if (!camera.takes(header.width(), header.height())) {
      throw row.invalid(
          column,
          "%s x %s pixels as camera.json says, or upright, not %s x %s"
              .formatted(camera.width(), camera.height(), header.width(), header.height()));
    }
    return new Picture(file, header);
  }

  private Path fileInFolder(String column) {
    try {
      Path file = folder.resolve(row.text(column));
      Path absolute = file.toAbsolutePath().normalize();
      if (!row.text(column).isEmpty() && absolute.startsWith(folder.toAbsolutePath().normalize())) {
        return file.normalize();
      }
    } catch (java.nio.file.InvalidPathException e) {
      // reported below
    }
    throw row.invalid(column, "the name of a picture in the folder");
  }

  private String object() {
    String name = row.text("object");
    if (!name.matches("[\\p{L}\\p{N}][\\p{L}\\p{N} ._-]{0,99}")) {
      throw row.invalid("object", "1 to 100 letters, digits, blanks or any of . _ -");
    }
    return name;
  }

  private double length(String column, double most) {
    return row.number(column, Double.MIN_NORMAL, most, "metres above 0, at most " + (long) most);
  }

  private double focalLength(Path image) {
    String column = "focal_length_m";
    if (!row.text(column).isEmpty()) {
      return length(column, MAX_FOCAL_LENGTH);
    }
    double metres =
        ImageHeader.focalLength(image)
            .orElseThrow(() -> row.invalid(column, "metres, or a photo whose EXIF has it"));
    if (metres <= MAX_FOCAL_LENGTH) {
      return metres;
    }
    throw row.invalid(
        column,
        "metres, since the photo's EXIF has %s m, which is no lens's (at most %s)"
            .formatted(metres, (long) MAX_FOCAL_LENGTH));
  }

  private Patch patch(String object, ImageHeader image) {
    Patch patch =
        PATCH.stream().allMatch(column -> row.text(column).isEmpty())
            ? coco.patch(row.text("image"), object)
                .orElseThrow(
                    () ->
                        row.invalid(
                            "patch_x",
                            "pixels, or one box for the image and object in " + Dataset.COCO))
            : new Patch(
                pixels("patch_x", 0),
                pixels("patch_y", 0),
                pixels("patch_width", 1),
                pixels("patch_height", 1));
    if (patch.width() < 1 || patch.height() < 1 || !patch.within(image.width(), image.height())) {
      throw row.place("patch_x")
          .error(
              "the patch is %s, expected one within the image's %s x %s pixels",
              patch, image.width(), image.height());
    }
    return patch;
  }

  private int pixels(String column, int least) {
    String expected = "a whole number of pixels from " + least;
    double value = row.number(column, least, MAX_PIXELS, expected);
    if (value != Math.rint(value)) {
      throw row.invalid(column, expected);
    }
    return (int) value;
  }
}
