package org.hificamsim.profiling.detector;

import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.hificamsim.profiling.dataset.Patch;
import org.hificamsim.profiling.opencv.Mats;
import org.opencv.calib3d.Calib3d;
import org.opencv.core.Core;
import org.opencv.core.DMatch;
import org.opencv.core.Mat;
import org.opencv.core.MatOfPoint2f;
import org.opencv.core.Point;

/** Which matches between an object's template and a photo count for the confidence. */
public enum MatchReading {
  /** All of them, wherever they are: Eq 5.1. */
  ANYWHERE(""),
  /** Those on the object's patch. */
  LOCATED("-located"),
  /** Those that agree on how the flat template lies in the photo: the inliers of RANSAC. */
  RANSAC("-ransac");

  private static final int POINTS_OF_A_HOMOGRAPHY = 4;

  /** How far a match may be from where the homography has it, pixels; OpenCV's default. */
  private static final double REACH = 3;

  private final String suffix;

  MatchReading(String suffix) {
    this.suffix = suffix;
  }

  /** What its detectors' names end in. */
  public String suffix() {
    return suffix;
  }

  /** The matches that count over all features of the template, in [0, 1]. */
  public double confidence(Features template, Features photo, List<DMatch> matches, Patch patch) {
    return template.count() == 0
        ? 0
        : (double) count(template, photo, matches, patch) / template.count();
  }

  private long count(Features template, Features photo, List<DMatch> matches, Patch patch) {
    return switch (this) {
      case ANYWHERE -> matches.size();
      case LOCATED ->
          matches.stream()
              .map(match -> photo.points()[match.trainIdx].pt)
              .filter(place -> patch.has(place.x, place.y))
              .count();
      case RANSAC ->
          matches.size() < POINTS_OF_A_HOMOGRAPHY ? 0 : inliers(template, photo, matches);
    };
  }

  /** The reading that a detector's name asks for. */
  static MatchReading of(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    return lower.endsWith(LOCATED.suffix)
        ? LOCATED
        : lower.endsWith(RANSAC.suffix) ? RANSAC : ANYWHERE;
  }

  private static int inliers(Features template, Features photo, List<DMatch> matches) {
    try (Mats mats = new Mats()) {
      Mat agree = mats.mat();
      mats.own(
          Calib3d.findHomography(
              mats.own(points(matches.stream().map(m -> template.points()[m.queryIdx].pt))),
              mats.own(points(matches.stream().map(m -> photo.points()[m.trainIdx].pt))),
              Calib3d.RANSAC,
              REACH,
              agree));
      return agree.empty() ? 0 : Core.countNonZero(agree);
    }
  }

  private static MatOfPoint2f points(Stream<Point> points) {
    return new MatOfPoint2f(points.toArray(Point[]::new));
  }
}
