package org.hificamsim.profiling.lab;

import com.fasterxml.jackson.annotation.JsonUnwrapped;
import com.fasterxml.jackson.core.util.DefaultIndenter;
import com.fasterxml.jackson.core.util.DefaultPrettyPrinter;
import com.fasterxml.jackson.core.util.Separators;
import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.ObjectWriter;
import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.SplittableRandom;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.PhotoCamera;
import org.hificamsim.profiling.dataset.TableLayout;
import org.hificamsim.profiling.detector.Photograph;
import org.hificamsim.profiling.opencv.Mats;
import org.hificamsim.profiling.opencv.OpenCv;
import org.opencv.core.Core;
import org.opencv.core.Mat;
import org.opencv.core.Rect;
import org.opencv.imgproc.Imgproc;

/** Renders the laboratory's experiment into a data set folder. */
public final class Laboratory {
  private final LabSettings settings;

  public Laboratory(LabSettings settings) {
    this.settings = settings;
  }

  /**
   * The outcome of the experiment.
   *
   * @param taken the number of pictures in the data set
   * @param dropped the number of pictures whose object does not fit the frame
   */
  public record PhotoCount(int taken, int dropped) {}

  /** Returns the number of pictures, including those that will be dropped. */
  public int shots() {
    return Shot.all(settings).size();
  }

  /**
   * Renders all pictures. The same settings give the same files on any number of threads.
   *
   * @param progress action to run once per picture, possibly on several threads
   */
  public PhotoCount render(Path folder, int threads, Runnable progress) {
    OpenCv.load();
    SplittableRandom random = new SplittableRandom(settings.seed());
    try (OutputFolder out = new OutputFolder(folder);
        Mats mats = new Mats();
        PhotoSurfaces surfaces = new PhotoSurfaces();
        Room room = Room.create(surfaces, settings.scene().clutter(), random.split())) {
      Photographer photographer = new Photographer(settings, room, textures(surfaces, mats));
      out.claim(List.of(Dataset.TABLE, Dataset.CAMERA));
      LabFolder files = new LabFolder(out);
      Parallel.map(
          settings.photographed(), threads, object -> writeTemplate(files, photographer, object));
      List<LabFolder.Row> rows =
          Parallel.map(
              Shot.all(settings),
              threads,
              shot -> {
                LabFolder.Row row = take(files, photographer, shot);
                progress.run();
                return row;
              });
      List<LabFolder.Row> taken = rows.stream().filter(Objects::nonNull).toList();
      PhotoCount outcome = new PhotoCount(taken.size(), rows.size() - taken.size());
      files.finish(settings, Sensor.scaled(settings.scale()), taken, outcome);
      return outcome;
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private Map<LabObject, Mat> textures(PhotoSurfaces surfaces, Mats mats) {
    int side = (int) Math.max(64, 1.2 * Sensor.scaled(settings.scale()).height());
    Map<LabObject, Mat> textures = new LinkedHashMap<>();
    for (LabObject object : settings.photographed()) {
      textures.put(object, mats.own(surfaces.object(object, side)));
    }
    return textures;
  }

  private static boolean writeTemplate(
      LabFolder files, Photographer photographer, LabObject object) {
    try (Mats mats = new Mats()) {
      files.writeTemplate(object, mats.own(photographer.template(object)));
      return true;
    }
  }

  /** Takes a picture and returns its row, or null if its object does not fit the frame. */
  private static LabFolder.Row take(LabFolder files, Photographer photographer, Shot shot) {
    try (Photographer.Photo photo = photographer.take(shot)) {
      if (Core.countNonZero(photo.mask()) == 0 || !Photographer.isWithinFrame(photo.mask())) {
        return null;
      }
      files.write(shot, photo);
      return new LabFolder.Row(shot, Imgproc.boundingRect(photo.mask()));
    }
  }

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

    /** The writer that puts each property on a line, and each list on one line. */
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

    /** The content of {@code lab.json}: the settings and the outcome. */
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

    /** Writes the tables and commits all files. */
    void finish(LabSettings settings, Sensor sensor, List<Row> rows, Laboratory.PhotoCount photos) {
      try {
        writeJson(
            Dataset.CAMERA,
            new PhotoCamera(Sensor.WIDTH, Sensor.HEIGHT, sensor.width(), sensor.height()));
        writeJson("lab.json", new Rendered(settings, photos));
        folder.write(Dataset.TABLE, TABLE.csv(rows));
        folder.commit(List.of());
      } catch (IOException e) {
        throw new UncheckedIOException(e);
      }
    }

    private void writeJson(String name, Object value) throws IOException {
      folder.write(name, JSON.writeValueAsString(value) + "\n");
    }
  }

  /**
   * A picture to take.
   *
   * @param index the number of the picture from 0, which determines its random seed
   * @param focalLength z, in metres
   * @param distance d, in metres
   */
  record Shot(int index, LabObject object, double focalLength, double distance) {
    /** Returns every combination of object, focal length and distance. */
    static List<Shot> all(LabSettings settings) {
      List<Shot> shots = new ArrayList<>();
      for (LabObject object : settings.photographed()) {
        for (double focalLength : settings.focalLengths()) {
          for (double distance : settings.distances()) {
            shots.add(new Shot(shots.size(), object, focalLength, distance));
          }
        }
      }
      return shots;
    }

    /** Returns the name of its files. */
    String name() {
      return Texts.format("%s-%02.0fmm-%04.1fm", object.name(), focalLength * 1000, distance);
    }
  }
}
