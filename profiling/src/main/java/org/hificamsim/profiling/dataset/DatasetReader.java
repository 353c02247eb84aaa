package org.hificamsim.profiling.dataset;

import java.io.IOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Optional;
import java.util.regex.Pattern;
import java.util.stream.Stream;
import org.hificamsim.core.InputException;
import org.hificamsim.data.CsvReader;
import org.hificamsim.data.CsvRow;
import org.hificamsim.data.CsvRows;

/** Reads a data set's folder and reports everything that is wrong with it. */
public final class DatasetReader {
  private static final List<String> COLUMNS =
      Stream.concat(
              Stream.of("image", "object", "size_m", "distance_m", "focal_length_m"),
              LabelledPhotoReader.PATCH.stream())
          .toList();
  private static final List<String> ENDINGS = List.of(".png", ".jpg", ".jpeg");

  private static final Pattern PICTURE =
      Pattern.compile("[^.].*\\.(png|jpg|jpeg)", Pattern.CASE_INSENSITIVE);

  private final Path folder;
  private final List<String> problems = new ArrayList<>();

  private DatasetReader(Path folder) {
    this.folder = folder;
  }

  /** Reads and checks a folder without decoding its pictures. */
  public static Reading read(Path folder) {
    DatasetReader reader = new DatasetReader(folder);
    Optional<Dataset> dataset = Optional.empty();
    try {
      dataset = reader.dataset();
    } catch (InputException e) {
      reader.problems.add(e.getMessage());
    }
    return new Reading(reader.problems.isEmpty() ? dataset : Optional.empty(), reader.problems);
  }

  /**
   * A data set, or the problems with it.
   *
   * @param dataset empty if there are problems
   * @param problems each in one line: {@code FILE:LINE:COLUMN: what is wrong, the value, what was
   *     expected}
   */
  public record Reading(Optional<Dataset> dataset, List<String> problems) {}

  private Optional<Dataset> dataset() {
    PhotoCamera camera = PhotoCamera.of(folder);
    Path cocoFile = folder.resolve(Dataset.COCO);
    CocoPatches coco = Files.exists(cocoFile) ? CocoPatches.read(cocoFile) : CocoPatches.none();
    CsvRows table =
        CsvReader.open(folder.resolve(Dataset.TABLE), "a data set's table").readAll(COLUMNS);
    if (table.rows().isEmpty()) {
      throw new InputException(table.file() + ":2:1: no rows, expected one for each picture");
    }
    List<LabelledPhoto> samples = new ArrayList<>();
    Map<String, Path> templates = new LinkedHashMap<>();
    Map<String, Integer> lines = new LinkedHashMap<>();
    for (CsvRow row : table.rows()) {
      checkOnce(row, lines);
      new LabelledPhotoReader(folder, camera, coco, row, problems).read().ifPresent(samples::add);
      addTemplate(row, templates);
    }
    List<Path> negatives = negatives(camera);
    return Optional.of(new Dataset(folder, camera, samples, templates, negatives));
  }

  private void checkOnce(CsvRow row, Map<String, Integer> lines) {
    Integer earlier = lines.putIfAbsent(row.text("image") + '\n' + row.text("object"), row.line());
    if (earlier != null) {
      problems.add(
          row.invalid("image", "each image and object once, and line " + earlier + " has it")
              .getMessage());
    }
  }

  private void addTemplate(CsvRow row, Map<String, Path> templates) {
    String name = row.text("object");
    if (templates.containsKey(name) || name.contains("/") || name.isEmpty()) {
      return;
    }
    templates.put(name, folder);
    for (String ending : ENDINGS) {
      Path file = folder.resolve("templates").resolve(name + ending);
      if (Files.exists(file)) {
        templates.put(name, file);
        checkReadable(row, file);
        return;
      }
    }
    problems.add(
        row.invalid("object", "its close-up as templates/" + name + ".png or .jpg").getMessage());
  }

  private void checkReadable(CsvRow row, Path file) {
    try {
      ImageHeader.read(file);
    } catch (IOException | RuntimeException e) {
      problems.add(
          row.invalid("object", file + " to be a whole PNG or JPEG (" + e.getMessage() + ")")
              .getMessage());
    }
  }

  /** Returns the pictures without any of the objects, sorted by name. */
  private List<Path> negatives(PhotoCamera camera) {
    Path pictures = folder.resolve(Dataset.NEGATIVES);
    if (!Files.isDirectory(pictures)) {
      return List.of();
    }
    try (Stream<Path> files = Files.list(pictures)) {
      return files
          .filter(file -> PICTURE.matcher(file.getFileName().toString()).matches())
          .sorted()
          .filter(file -> isReadable(camera, file))
          .toList();
    } catch (IOException e) {
      problems.add(pictures + ": cannot be read, expected a folder of photos: " + e.getMessage());
      return List.of();
    }
  }

  /**
   * Whether a picture can be read and has the size of the camera; otherwise reports the problem.
   */
  private boolean isReadable(PhotoCamera camera, Path file) {
    try {
      ImageHeader header = ImageHeader.read(file);
      if (!camera.takes(header.width(), header.height())) {
        throw new IOException(
            "is %s x %s pixels, expected %s x %s as camera.json says, or upright"
                .formatted(header.width(), header.height(), camera.width(), camera.height()));
      }
      return true;
    } catch (IOException | RuntimeException e) {
      problems.add(file + ": " + e.getMessage());
      return false;
    }
  }
}
