package org.hificamsim.profiling.report;

import java.util.List;
import java.util.Map;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.stat.regression.SimpleRegression;
import org.apache.commons.math3.util.MathArrays;
import org.hificamsim.profiling.fit.FeatureResult;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.FitScores;
import org.hificamsim.profiling.measure.Measurement;
import org.hificamsim.profiling.measure.PipReading;

/**
 * The six real photos of Figure 3.7, a ball at 1 m, as a check of every f; no fit has seen them.
 * The thesis does not say how big the ball is: {@value #BALL} m is a football's diameter. It counts
 * the rectangle around the ball; the ball itself is the disc within.
 *
 * @param reading how the data were counted that the f were fitted to, and so how the ball is
 */
record HeldOut(PipReading reading, List<Measurement> photos) {
  /** Metres. */
  static final double BALL = 0.22;

  private static final double DISC = Math.PI / 4;

  static HeldOut of(PipReading reading) {
    double share = reading == PipReading.SILHOUETTE ? DISC : 1;
    return new HeldOut(
        reading, PublishedTables.ball().stream().map(row -> photo(row, share)).toList());
  }

  private static Measurement photo(Map<String, String> row, double share) {
    double patch = number(row, "patch_width_px") * number(row, "patch_height_px");
    double image = number(row, "image_width_px") * number(row, "image_height_px");
    return new Measurement(
        "", "ball", BALL, 1, number(row, "focal_length_m"), share * patch / image, Map.of());
  }

  private static double number(Map<String, String> row, String column) {
    return Double.parseDouble(row.get(column));
  }

  List<Double> pips() {
    return photos.stream().map(Measurement::pip).toList();
  }

  /** How an f did: the root of the mean squared error and the mean error, of -log10(PIP). */
  record Check(String f, double rmse, double bias, List<Double> pips) {}

  /** The check of every f. */
  List<Check> checks(FitResult result) {
    return result.features().stream().map(this::check).toList();
  }

  private Check check(FeatureResult f) {
    double[] observed = Measurement.responses(photos);
    double[] predicted = photos.stream().mapToDouble(f.fit()::response).toArray();
    return new Check(
        f.name(),
        FitScores.of(observed, predicted).rmse(),
        StatUtils.mean(MathArrays.ebeSubtract(predicted, observed)),
        photos.stream().map(f.fit()::pip).toList());
  }

  /** The exponent of the focal length in these photos' PIP; 2 by the pinhole law. */
  double exponent() {
    SimpleRegression line = new SimpleRegression();
    photos.forEach(o -> line.addData(Math.log(o.focalLength()), Math.log(o.pip())));
    return line.getSlope();
  }
}
