package org.hificamsim.profiling.report;

import java.util.List;
import java.util.Map;
import org.apache.commons.math3.stat.regression.SimpleRegression;
import org.hificamsim.profiling.fit.FeatureResult;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.Observation;
import org.hificamsim.profiling.fit.Scores;
import org.hificamsim.profiling.measure.PipReading;

/**
 * The six real photos of Figure 3.7, a ball at 1 m, as a check of every f; no fit has seen them.
 * The thesis does not say how big the ball is: {@value #BALL} m is a football's diameter. It counts
 * the rectangle around the ball; the ball itself is the disc within.
 */
final class HeldOut {
  /** Metres. */
  static final double BALL = 0.22;

  private static final double DISC = Math.PI / 4;

  private final PipReading reading;
  private final List<Observation> photos;

  /**
   * @param reading how the data were counted that the f were fitted to, and so how the ball is
   */
  HeldOut(PipReading reading) {
    this.reading = reading;
    double share = reading == PipReading.SILHOUETTE ? DISC : 1;
    photos = PublishedTables.ball().stream().map(row -> photo(row, share)).toList();
  }

  /** How the ball is counted. */
  PipReading reading() {
    return reading;
  }

  /** How an f did: the root of the mean squared error and the mean error, of -log10(PIP). */
  record Check(String f, double rmse, double bias, List<Double> pips) {}

  List<Observation> photos() {
    return photos;
  }

  /** The check of every f. */
  List<Check> checks(FitResult result) {
    return result.features().stream().map(this::check).toList();
  }

  /** The exponent of the focal length in these photos' PIP; 2 by the pinhole law. */
  double exponent() {
    SimpleRegression line = new SimpleRegression();
    photos.forEach(o -> line.addData(Math.log(o.focalLength()), Math.log(o.pip())));
    return line.getSlope();
  }

  private Check check(FeatureResult f) {
    double[] observed = photos.stream().mapToDouble(Observation::response).toArray();
    double[] predicted = photos.stream().mapToDouble(f.fit()::response).toArray();
    double bias = 0;
    for (int i = 0; i < observed.length; i++) {
      bias += (predicted[i] - observed[i]) / observed.length;
    }
    List<Double> pips = photos.stream().map(f.fit()::pip).toList();
    return new Check(f.name(), Scores.of(observed, predicted).rmse(), bias, pips);
  }

  private static Observation photo(Map<String, String> row, double share) {
    double patch = number(row, "patch_width_px") * number(row, "patch_height_px");
    double image = number(row, "image_width_px") * number(row, "image_height_px");
    return new Observation(BALL, 1, number(row, "focal_length_m"), share * patch / image);
  }

  private static double number(Map<String, String> row, String column) {
    return Double.parseDouble(row.get(column));
  }
}
