package org.hificamsim.profiling.report;

import static org.hificamsim.profiling.report.CellText.fixed;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.apache.commons.math3.stat.StatUtils;
import org.apache.commons.math3.util.MathArrays;
import org.hificamsim.profiling.dataset.TableLayout;
import org.hificamsim.profiling.fit.FeatureResult;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.FitScores;
import org.hificamsim.profiling.measure.Measurement;
import org.hificamsim.profiling.measure.PipReading;

/**
 * The six real photos of Figure 3.7, a ball at 1 m, on which every f is tested. The thesis does not
 * give the size of the ball; {@value #BALL} m is the diameter of a football. Its PIP counts the
 * rectangle around the ball; the ball itself is the inscribed disc.
 *
 * @param reading the pixels that count as the ball's, as in the data of the fits
 */
record HeldOut(PipReading reading, List<Measurement> photos) {
  /** The diameter of the ball, in metres. */
  private static final double BALL = 0.22;

  /** The share of the rectangle around the ball that the disc fills. */
  private static final double DISC_SHARE = Math.PI / 4;

  static HeldOut of(PipReading reading) {
    double share = reading == PipReading.SILHOUETTE ? DISC_SHARE : 1;
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

  /**
   * A row of the table: the PIP of the ball as measured or as an f predicts it.
   *
   * @param rmse the root of the mean squared error of -log10(PIP)
   * @param bias the mean error of -log10(PIP)
   * @param pips the PIP of each photo
   */
  private record Row(String f, String rmse, String bias, List<Double> pips) {}

  /** Adds the table of measured and predicted PIPs. */
  void table(HtmlPage page, FitResult result) {
    TableLayout<Row> layout =
        new TableLayout<Row>().with("f", Row::f).with("RMSE", Row::rmse).with("bias", Row::bias);
    for (int i = 0; i < photos.size(); i++) {
      int photo = i;
      layout.with(
          Math.round(photos.get(i).focalLength() * 1000) + " mm",
          row -> fixed(row.pips.get(photo), 4));
    }
    List<Row> rows = new ArrayList<>();
    String shape = reading == PipReading.RECTANGLE ? "rectangle" : "disc";
    List<Double> measured = photos.stream().map(Measurement::pip).toList();
    rows.add(new Row("measured PIP, the ball's " + shape, "", "", measured));
    result.features().forEach(f -> rows.add(predicted(f)));
    page.table(layout, rows);
  }

  private Row predicted(FeatureResult f) {
    double[] observed = Measurement.responses(photos);
    double[] predicted = photos.stream().mapToDouble(f.fit()::response).toArray();
    return new Row(
        f.name(),
        fixed(FitScores.of(observed, predicted).rmse(), 3),
        fixed(StatUtils.mean(MathArrays.ebeSubtract(predicted, observed)), 3),
        photos.stream().map(f.fit()::pip).toList());
  }

  /** Returns the explanation of the table. */
  String remark() {
    return "In these photos PIP grows with the focal length to the power 1.32, not 2 as a pinhole"
        + " camera's would, so that no f that is true to optics fits them all. The ball's size is"
        + " not published and taken as 0.22 m; another one shifts every f alike and does not change"
        + " the power. "
        + (reading == PipReading.RECTANGLE
            ? "PIP counts the rectangle around the ball, in the thesis and in these measurements."
            : "The thesis counts the rectangle around the ball, these measurements the object"
                + " alone: they are held against the disc in it, pi/4 of the rectangle (0.10 less"
                + " in log10). pinhole predicts the square of side q, whatever was counted. Photos"
                + " measured with pip rectangle are counted as in the thesis.");
  }
}
