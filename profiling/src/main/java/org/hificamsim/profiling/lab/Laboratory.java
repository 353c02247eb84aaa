package org.hificamsim.profiling.lab;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Path;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import java.util.Objects;
import java.util.SplittableRandom;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.core.parallel.Parallel;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.opencv.Mats;
import org.hificamsim.profiling.opencv.OpenCv;
import org.opencv.core.Core;
import org.opencv.core.Mat;
import org.opencv.imgproc.Imgproc;

/** Renders the laboratory's experiment into a data set folder. */
public final class Laboratory {
  private final LabSettings settings;

  public Laboratory(LabSettings settings) {
    this.settings = settings;
  }

  /**
   * What became of the experiment.
   *
   * @param taken pictures in the data set
   * @param dropped pictures whose object does not fit the frame
   */
  public record PhotoCount(int taken, int dropped) {}

  /** The number of pictures that will be tried. */
  public int shots() {
    return Shot.all(settings).size();
  }

  /**
   * Renders everything; the same settings give the same files on any number of threads.
   *
   * @param progress called once per picture, by any thread
   */
  public PhotoCount render(Path folder, int threads, Runnable progress) {
    OpenCv.load();
    SplittableRandom random = new SplittableRandom(settings.seed());
    try (OutputFolder out = new OutputFolder(folder);
        Mats mats = new Mats();
        PhotoSurfaces surfaces = new PhotoSurfaces();
        Room room = Room.furnished(surfaces, settings.scene().clutter(), random.split())) {
      Photographer photographer = new Photographer(settings, room, textures(surfaces, mats));
      out.claim(List.of(Dataset.TABLE, Dataset.CAMERA));
      LabFolder files = new LabFolder(out);
      Parallel.map(
          settings.photographed(), threads, object -> template(files, photographer, object));
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
      textures.put(object, mats.own(surfaces.target(object, side)));
    }
    return textures;
  }

  private static boolean template(LabFolder files, Photographer photographer, LabObject object) {
    try (Mats mats = new Mats()) {
      files.writeTemplate(object, mats.own(photographer.template(object)));
      return true;
    }
  }

  /** One picture's row, or null where its object does not fit the frame. */
  private static LabFolder.Row take(LabFolder files, Photographer photographer, Shot shot) {
    try (Photographer.Photo photo = photographer.take(shot)) {
      if (Core.countNonZero(photo.mask()) == 0 || !Photographer.within(photo.mask())) {
        return null;
      }
      files.write(shot, photo);
      return new LabFolder.Row(shot, Imgproc.boundingRect(photo.mask()));
    }
  }
}
