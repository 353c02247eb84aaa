package org.hificamsim.profiling.lab;

import com.fasterxml.jackson.annotation.JsonUnwrapped;
import com.fasterxml.jackson.core.JsonProcessingException;
import com.fasterxml.jackson.core.PrettyPrinter;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.core.util.Separators;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.ObjectWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.charset.StandardCharsets;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.List;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.profiling.dataset.PhotoCamera;
import org.hificamsim.profiling.dataset.TableLayout;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Mat;
import org.opencv.core.MatOfByte;
import org.opencv.core.MatOfInt;
import org.opencv.core.Rect;
import org.opencv.imgcodecs.Imgcodecs;

/** Writes a rendered experiment as a data set, each file whole or not at all. */
final class LabFolder {
  private static final int JPEG_QUALITY = 95;
  private static final TableLayout<LabRow> TABLE =
      new TableLayout<LabRow>()
          .with("image", LabRow::image)
          .with("object", row -> row.shot().object().name())
          .with("size_m", row -> row.shot().object().q())
          .with("distance_m", row -> row.shot().distance())
          .with("focal_length_m", row -> row.shot().focalLength())
          .with("patch_x", row -> row.patch().x)
          .with("patch_y", row -> row.patch().y)
          .with("patch_width", row -> row.patch().width)
          .with("patch_height", row -> row.patch().height)
          .with("mask", LabRow::mask)
          .with("aperture", row -> row.conditions().aperture())
          .with("distortion", row -> row.conditions().distortion())
          .with("light", row -> row.conditions().light());

  private static final ObjectWriter JSON = new ObjectMapper().writer(printer());

  private final Path folder;

  /** What {@code lab.json} holds: all settings and what became of them, side by side. */
  private record Rendered(
      @JsonUnwrapped LabSettings settings, @JsonUnwrapped Laboratory.PhotoCount photos) {}

  LabFolder(Path folder) {
    this.folder = folder;
  }

  void writeTemplate(LabObject object, Mat picture) {
    encode("templates/" + object.name() + ".png", picture);
  }

  LabRow write(Shot shot, Photo photo, Rect patch) {
    String image = "images/" + shot.name() + ".jpg";
    String mask = "masks/" + shot.name() + ".png";
    encode(image, photo.image());
    encode(mask, photo.mask());
    return new LabRow(shot, image, mask, patch, photo.conditions());
  }

  /** Writes the tables last: a folder with a {@code dataset.csv} is complete. */
  void finish(
      LabSettings settings, Sensor sensor, List<LabRow> rows, Laboratory.PhotoCount photos) {
    json(
        "camera.json",
        new PhotoCamera(Sensor.WIDTH, Sensor.HEIGHT, sensor.width(), sensor.height()));
    json("lab.json", new Rendered(settings, photos));
    text("dataset.csv", TABLE.csv(rows));
  }

  private void encode(String name, Mat picture) {
    String extension = name.substring(name.lastIndexOf('.'));
    try (Mats mats = new Mats()) {
      MatOfByte bytes = mats.own(new MatOfByte());
      MatOfInt options = mats.own(new MatOfInt(Imgcodecs.IMWRITE_JPEG_QUALITY, JPEG_QUALITY));
      if (!Imgcodecs.imencode(extension, picture, bytes, options)) {
        throw new IllegalStateException("OpenCV cannot encode " + name);
      }
      write(name, bytes.toArray());
    }
  }

  private void json(String name, Object value) {
    try {
      text(name, JSON.writeValueAsString(value) + "\n");
    } catch (JsonProcessingException e) {
      throw new UncheckedIOException(e);
    }
  }

  /** A property a line, lists on one. */
  private static PrettyPrinter printer() {
    return new DefaultPrettyPrinter(
            Separators.createDefaultInstance()
                .withObjectFieldValueSpacing(Separators.Spacing.AFTER)
                .withArrayValueSpacing(Separators.Spacing.AFTER))
        .withObjectIndenter(new DefaultIndenter("  ", "\n"))
        .withArrayIndenter(DefaultPrettyPrinter.NopIndenter.instance);
  }

  private void text(String name, String content) {
    write(name, content.getBytes(StandardCharsets.UTF_8));
  }

  private void write(String name, byte[] bytes) {
    try {
      Path file = folder.resolve(name);
      Files.createDirectories(file.toAbsolutePath().getParent());
      new OutputFile(file).write(out -> out.write(bytes));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
