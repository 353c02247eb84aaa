package org.hificamsim.profiling.measure;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.Collection;
import java.util.List;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.LabelledPhoto;
import org.hificamsim.profiling.detector.Detectors;
import org.hificamsim.profiling.detector.FeatureDetector;
import org.hificamsim.profiling.detector.Features;
import org.hificamsim.profiling.detector.Photograph;
import org.hificamsim.profiling.opencv.Mats;
import org.hificamsim.profiling.opencv.OpenCv;
import org.opencv.core.DMatch;
import org.opencv.core.Mat;
import org.opencv.core.MatOfByte;
import org.opencv.core.MatOfDMatch;
import org.opencv.core.MatOfKeyPoint;
import org.opencv.core.Scalar;
import org.opencv.features2d.Features2d;
import org.opencv.imgcodecs.Imgcodecs;

/** Draws which template features are found where, as in Figures 5.2, 5.4 and 5.6. */
public record MatchPictures(Dataset dataset, MeasureSettings settings) {
  /** The folder of the pictures. */
  public static final String FOLDER = "matches";

  /** Draws some images' matches, one picture for each feature detector; returns how many. */
  public int draw(Collection<String> images) {
    OpenCv.load();
    List<String> extractors = Detectors.extractors(settings.detectors());
    int drawn = 0;
    try (Templates templates = Templates.of(dataset, extractors, 1)) {
      for (LabelledPhoto sample : dataset.samples()) {
        if (images.contains(sample.image())) {
          extractors.forEach(extractor -> draw(sample, extractor, templates));
          drawn += extractors.size();
        }
      }
    }
    return drawn;
  }

  private void draw(LabelledPhoto sample, String extractor, Templates templates) {
    Features template = templates.of(sample.object(), extractor);
    try (Photograph photo = new Photograph(sample.file());
        Photograph close = new Photograph(dataset.templates().get(sample.object()));
        FeatureDetector detector = Detectors.create(extractor);
        Features features =
            Failures.named(sample.file(), extractor, () -> detector.detect(photo.grey()));
        Mats mats = new Mats()) {
      Mat picture = picture(mats, close.grey(), template, photo.grey(), features);
      write(picture, extractor + "-" + name(sample) + ".jpg");
    }
  }

  private Mat picture(Mats mats, Mat close, Features template, Mat photo, Features features) {
    DMatch[] matches = settings.test().matches(template, features).toArray(DMatch[]::new);
    Mat picture = mats.mat();
    Features2d.drawMatches(
        close,
        mats.own(new MatOfKeyPoint(template.points())),
        photo,
        mats.own(new MatOfKeyPoint(features.points())),
        mats.own(new MatOfDMatch(matches)),
        picture,
        Scalar.all(-1),
        Scalar.all(-1),
        mats.own(new MatOfByte()),
        Features2d.DrawMatchesFlags_NOT_DRAW_SINGLE_POINTS);
    return picture;
  }

  private void write(Mat picture, String name) {
    Path folder = dataset.folder().resolve(FOLDER);
    try (Mats mats = new Mats()) {
      MatOfByte bytes = mats.own(new MatOfByte());
      Imgcodecs.imencode(".jpg", picture, bytes);
      Files.createDirectories(folder);
      new OutputFile(folder.resolve(name)).write(out -> out.write(bytes.toArray()));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }

  private static String name(LabelledPhoto sample) {
    return sample.image().replaceAll("[/\\\\]", "_").replaceFirst("\\.[^.]*$", "");
  }
}
