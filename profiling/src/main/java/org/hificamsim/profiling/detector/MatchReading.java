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

/** Selects which matches between an object's template and a photo count for the confidence. */
public enum MatchReading {
  /** All matches, wherever they are: Eq 5.1. */
  ANYWHERE(""),
  /** The matches on the object's patch. */
  LOCATED("-located"),
  /** The matches that agree on one homography of the flat template, the inliers of RANSAC. */
  RANSAC("-ransac");

  private static final int POINTS_OF_A_HOMOGRAPHY = 4;

  /**
   * The largest distance of an inlier from its position under the homography, in pixels; OpenCV's
   * default.
   */
  private static final double MAX_INLIER_DISTANCE = 3;

  private final String suffix;

  MatchReading(String suffix) {
    this.suffix = suffix;
  }

  /** Returns the suffix of detector names with this reading. */
  public String suffix() {
    return suffix;
  }

  /** Returns the number of counted matches divided by that of template features, in [0, 1]. */
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
              .filter(point -> patch.contains(point.x, point.y))
              .count();
      case RANSAC ->
          matches.size() < POINTS_OF_A_HOMOGRAPHY ? 0 : inliers(template, photo, matches);
    };
  }

  /** Returns the reading that a detector's name ends in. */
  static MatchReading of(String name) {
    String lower = name.toLowerCase(Locale.ROOT);
    return lower.endsWith(LOCATED.suffix)
        ? LOCATED
        : lower.endsWith(RANSAC.suffix) ? RANSAC : ANYWHERE;
  }

  private static int inliers(Features template, Features photo, List<DMatch> matches) {
    try (Mats mats = new Mats()) {
      Mat inlierMask = mats.mat();
      mats.own(
          Calib3d.findHomography(
              mats.own(points(matches.stream().map(match -> template.points()[match.queryIdx].pt))),
              mats.own(points(matches.stream().map(match -> photo.points()[match.trainIdx].pt))),
              Calib3d.RANSAC,
              MAX_INLIER_DISTANCE,
              inlierMask));
      return inlierMask.empty() ? 0 : Core.countNonZero(inlierMask);
    }
  }

  private static MatOfPoint2f points(Stream<Point> points) {
    return new MatOfPoint2f(points.toArray(Point[]::new));
  }
}
