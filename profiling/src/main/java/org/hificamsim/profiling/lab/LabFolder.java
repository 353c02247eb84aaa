package org.hificamsim.profiling.lab;

import com.fasterxml.jackson.annotation.JsonUnwrapped;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.core.util.Separators;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.ObjectWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.util.List;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.PhotoCamera;
import org.hificamsim.profiling.dataset.TableLayout;
import org.hificamsim.profiling.detector.Photograph;
import org.opencv.core.Mat;
import org.opencv.core.Rect;

/** Writes a rendered experiment as a data set, all files or none. */
record LabFolder(OutputFolder folder) {
  private static final TableLayout<Row> TABLE =
      new TableLayout<Row>()
          .with("image", row -> image(row.shot))
          .with("object", row -> row.shot.object().name())
          .with("size_m", row -> row.shot.object().q())
          .with("distance_m", row -> row.shot.distance())
          .with("focal_length_m", row -> row.shot.focalLength())
          .with("patch_x", row -> row.patch.x)
          .with("patch_y", row -> row.patch.y)
          .with("patch_width", row -> row.patch.width)
          .with("patch_height", row -> row.patch.height)
          .with("mask", row -> mask(row.shot));

  /** A property a line, lists on one. */
  private static final ObjectWriter JSON =
      new ObjectMapper()
          .writer(
              new DefaultPrettyPrinter(
                      Separators.createDefaultInstance()
                          .withObjectFieldValueSpacing(Separators.Spacing.AFTER)
                          .withArrayValueSpacing(Separators.Spacing.AFTER))
                  .withObjectIndenter(new DefaultIndenter("  ", "\n"))
                  .withArrayIndenter(DefaultPrettyPrinter.NopIndenter.instance));

  /** A picture's row in the data set. */
  record Row(Shot shot, Rect patch) {}

  /** What {@code lab.json} holds: all settings and what became of them, side by side. */
  private record Rendered(
      @JsonUnwrapped LabSettings settings, @JsonUnwrapped Laboratory.PhotoCount photos) {}

  private static String image(Shot shot) {
    return "images/" + shot.name() + ".jpg";
  }

  private static String mask(Shot shot) {
    return "masks/" + shot.name() + ".png";
  }

  void writeTemplate(LabObject object, Mat picture) {
    Photograph.write(folder, "templates/" + object.name() + ".png", picture);
  }

  void write(Shot shot, Photographer.Photo photo) {
    Photograph.write(folder, image(shot), photo.image());
    Photograph.write(folder, mask(shot), photo.mask());
  }

  /** Writes the tables, and moves everything into place. */
  void finish(LabSettings settings, Sensor sensor, List<Row> rows, Laboratory.PhotoCount photos) {
    try {
      json(
          Dataset.CAMERA,
          new PhotoCamera(Sensor.WIDTH, Sensor.HEIGHT, sensor.width(), sensor.height()));
      json("lab.json", new Rendered(settings, photos));
      folder.write(Dataset.TABLE, TABLE.csv(rows));
      folder.commit(List.of());
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private void json(String name, Object value) throws IOException {
    folder.write(name, JSON.writeValueAsString(value) + "\n");
  }
}
