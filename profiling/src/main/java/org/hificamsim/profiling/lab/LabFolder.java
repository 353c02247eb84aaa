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
import java.util.Locale;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.profiling.dataset.PhotoCamera;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Mat;
import org.opencv.core.MatOfByte;
import org.opencv.core.MatOfInt;
import org.opencv.core.Rect;
import org.opencv.imgcodecs.Imgcodecs;

/** Writes a rendered experiment as a data set, each file whole or not at all. */
final class LabFolder {
  private static final int JPEG_QUALITY = 95;
  private static final String HEADER =
      "image,object,size_m,distance_m,focal_length_m,patch_x,patch_y,patch_width,patch_height,mask"
          + ",aperture,distortion,light";

  private static final ObjectWriter JSON = new ObjectMapper().writer(printer());

  private final Path folder;

  /** What {@code lab.json} holds: all settings and what became of them, side by side. */
  private record Rendered(
      @JsonUnwrapped LabSettings settings, @JsonUnwrapped Laboratory.PhotoCount outcome) {}

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
  void finish(LabSettings settings, Sensor sensor, List<LabRow> rows, Laboratory.PhotoCount outcome) {
    json(
        "camera.json",
        new PhotoCamera(Sensor.WIDTH, Sensor.HEIGHT, sensor.width(), sensor.height()));
    json("lab.json", new Rendered(settings, outcome));
    StringBuilder table = new StringBuilder(HEADER).append('\n');
    rows.forEach(row -> table.append(line(row)).append('\n'));
    text("dataset.csv", table.toString());
  }

  private static String line(LabRow row) {
    Shot shot = row.shot();
    Rect patch = row.patch();
    return String.format(
        Locale.ROOT,
        "%s,%s,%s,%s,%s,%d,%d,%d,%d,%s,%s,%s,%s",
        row.image(),
        shot.object().name(),
        shot.object().q(),
        shot.distance(),
        shot.focalLength(),
        patch.x,
        patch.y,
        patch.width,
        patch.height,
        row.mask(),
        row.conditions().aperture(),
        row.conditions().distortion(),
        row.conditions().light());
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
