package org.hificamsim.profiling.measure;

import java.io.IOException;
import java.io.UncheckedIOException;
import java.nio.file.Files;
import java.nio.file.Path;
import org.hificamsim.core.file.OutputFile;
import org.hificamsim.profiling.dataset.Sample;
import org.hificamsim.profiling.detector.Features;
import org.hificamsim.profiling.detector.RatioTest;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.core.Mat;
import org.opencv.core.MatOfByte;
import org.opencv.core.MatOfDMatch;
import org.opencv.core.MatOfKeyPoint;
import org.opencv.core.Scalar;
import org.opencv.features2d.Features2d;
import org.opencv.imgcodecs.Imgcodecs;

/**
 * Draws which template features were found where, as in Figures 5.2, 5.4 and 5.6.
 *
 * @param folder where the pictures go
 */
record MatchPictures(Path folder) {
  /** Draws one photo's matches; {@code close} is released. */
  void draw(
      Sample sample,
      String detector,
      Mat close,
      Features template,
      Mat photo,
      Features features,
      RatioTest test) {
    try (Mats mats = new Mats()) {
      mats.own(close);
      MatOfDMatch matches =
          mats.own(
              new MatOfDMatch(
                  test.matches(template, features).toArray(new org.opencv.core.DMatch[0])));
      Mat picture = mats.mat();
      Features2d.drawMatches(
          close,
          mats.own(new MatOfKeyPoint(template.points())),
          photo,
          mats.own(new MatOfKeyPoint(features.points())),
          matches,
          picture,
          Scalar.all(-1),
          Scalar.all(-1),
          mats.own(new MatOfByte()),
          Features2d.DrawMatchesFlags_NOT_DRAW_SINGLE_POINTS);
      MatOfByte bytes = mats.own(new MatOfByte());
      Imgcodecs.imencode(".jpg", picture, bytes);
      String name = sample.image().replaceAll("[/\\\\]", "_").replaceFirst("\\.[^.]*$", "");
      Files.createDirectories(folder);
      new OutputFile(folder.resolve(detector + "-" + name + ".jpg"))
          .write(out -> out.write(bytes.toArray()));
    } catch (IOException e) {
      throw new UncheckedIOException(e);
    }
  }
}
