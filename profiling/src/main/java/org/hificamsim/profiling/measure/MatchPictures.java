package org.hificamsim.profiling.measure;

import java.io.IOException;
import java.util.Collection;
import java.util.List;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.profiling.dataset.Dataset;
import org.hificamsim.profiling.dataset.LabelledPhoto;
import org.hificamsim.profiling.detector.Detectors;
import org.hificamsim.profiling.detector.FeatureDetector;
import org.hificamsim.profiling.detector.Features;
import org.hificamsim.profiling.detector.Photograph;
import org.hificamsim.profiling.detector.Templates;
import org.hificamsim.profiling.measure.Measurer.MeasureSettings;
import org.hificamsim.profiling.opencv.Mats;
import org.hificamsim.profiling.opencv.OpenCv;
import org.opencv.core.DMatch;
import org.opencv.core.Mat;
import org.opencv.core.MatOfByte;
import org.opencv.core.MatOfDMatch;
import org.opencv.core.MatOfKeyPoint;
import org.opencv.core.Scalar;
import org.opencv.features2d.Features2d;

/** Draws the matches between templates and photos, as in Figures 5.2, 5.4 and 5.6. */
public record MatchPictures(Dataset dataset, MeasureSettings settings) {
  /** The folder of the pictures. */
  public static final String FOLDER = "matches";

  /**
   * Draws the matches of some images, one picture for each feature detector; returns their number.
   */
  public int draw(Collection<String> images) throws IOException {
    OpenCv.load();
    List<FeatureDetector> detectors = Detectors.features(settings.detectors());
    int drawn = 0;
    try (OutputFolder folder = new OutputFolder(dataset.folder());
        Templates templates = new Templates(dataset.templates(), detectors, 1)) {
      for (LabelledPhoto sample : dataset.samples()) {
        if (images.contains(sample.image())) {
          detectors.forEach(detector -> draw(sample, detector, templates, folder));
          drawn += detectors.size();
        }
      }
      folder.commit(List.of());
    }
    return drawn;
  }

  private void draw(
      LabelledPhoto sample, FeatureDetector detector, Templates templates, OutputFolder folder) {
    Features template = templates.features(sample.object(), detector);
    try (Photograph photo = new Photograph(sample.file());
        Photograph closeUp = new Photograph(dataset.templates().get(sample.object()));
        Features features =
            photo.detect(detector.word(), () -> detector.extractor().features(photo.grey()));
        Mats mats = new Mats()) {
      String stem = sample.image().replaceAll("[/\\\\]", "_").replaceFirst("\\.[^.]*$", "");
      Photograph.write(
          folder,
          FOLDER + "/" + detector.word() + "-" + stem + ".jpg",
          picture(mats, closeUp.grey(), template, photo.grey(), features));
    }
  }

  private Mat picture(Mats mats, Mat closeUp, Features template, Mat photo, Features features) {
    DMatch[] matches = settings.test().matches(template, features).toArray(DMatch[]::new);
    Mat picture = mats.mat();
    Features2d.drawMatches(
        closeUp,
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
}
