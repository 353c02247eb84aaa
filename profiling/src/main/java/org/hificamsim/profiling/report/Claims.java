package org.hificamsim.profiling.report;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.profiling.dataset.TableLayout;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.measure.Measurement;

/** The thesis's statements of chapters 4 to 6 and 9, judged on a data set; shares are R2. */
final class Claims {
  static final String FILE = "verdicts.csv";

  private static final TableLayout<Claim> COLUMNS =
      new TableLayout<Claim>()
          .with("source", claim -> '"' + claim.source() + '"')
          .with("claim", claim -> '"' + claim.text() + '"')
          .with("published", Claim::published)
          .with("value", Claim::yours)
          .with("verdict", Claim::verdict);

  private static final Map<String, String> SECTIONS =
      new TreeMap<>(Map.of("lin", "4.5.1", "sr", "4.5.2", "svr-lin", "4.5.3", "svr-rbf", "4.5.3"));
  private static final List<String> METHODS = List.of("svr-rbf", "lin", "sr");

  /** The largest difference from a published share that counts as reproduced, as in Table 8.1. */
  private static final double TOLERANCE = 0.05;

  private static final double ROUNDING = 1e-9;

  private final FitResult result;
  private final List<Claim> all = new ArrayList<>();

  /** Judges all statements on the measured detectors, in the order of the text. */
  Claims(FitResult result) {
    this.result = result;
    List<String> detectors =
        result.detectors().stream()
            .filter(detector -> !PublishedTables.groundTruthLine(detector).isEmpty())
            .toList();
    addFeatures();
    addDetectors(detectors);
  }

  /** Judges the statements of chapter 4. */
  private void addFeatures() {
    double[] responses = Measurement.responses(result.measurements());
    addShare("4.3", "The skewness of -log10(PIP)", -0.009, Variable.skewness(responses));
    SECTIONS.forEach(
        (f, section) ->
            addShare(
                section,
                "What " + f + " captures of -log10(PIP), in its best fold",
                number(PublishedTables.feature(f), "r2_best"),
                StatUtils.max(result.feature(f).validation().folds())));
    SECTIONS.forEach(
        (f, section) ->
            addShare(
                section,
                "What " + f + " captures of -log10(PIP), in the mean of its folds",
                number(PublishedTables.feature(f), "r2_cv_mean"),
                result.feature(f).validation().mean()));
    addOrder(
        "4.6",
        "Of the three methods, which predicts PIP best",
        METHODS,
        f -> number(PublishedTables.feature(f), "r2_cv_mean"),
        f -> result.feature(f).validation().mean());
  }

  /** Judges the statements of chapters 5, 6 and 9. */
  private void addDetectors(List<String> detectors) {
    for (String detector : detectors) {
      addShare(
          "5.4 to 5.6",
          "What measured PIP captures of the confidence of " + detector,
          number(PublishedTables.groundTruthLine(detector), "r2"),
          r2(detector, FitResult.GROUND_TRUTH));
    }
    if (detectors.size() > 1) {
      addOrder(
          "5.7",
          "Which detector's confidence PIP captures best",
          detectors,
          detector -> number(PublishedTables.groundTruthLine(detector), "r2"),
          detector -> r2(detector, FitResult.GROUND_TRUTH));
    }
    for (String detector : detectors) {
      addShare(
          "6.1, Table 6.1",
          "What g(f_lin) captures of the confidence of " + detector,
          number(PublishedTables.line(detector, "lin"), "r2"),
          r2(detector, "lin"));
    }
    for (String detector : detectors) {
      addOrder(
          "6.1, Table 6.1",
          "Which f captures the confidence of " + detector + " best",
          METHODS,
          f -> number(PublishedTables.line(detector, f), "r2"),
          f -> r2(detector, f));
    }
    for (String detector : detectors) {
      addShare(
          "6.2, Table 6.2",
          "What Eq 6.2 captures of the confidence of " + detector,
          number(PublishedTables.camSimLine(detector), "r2"),
          r2(detector, FitResult.CAMSIM));
    }
    for (String detector : detectors) {
      addOrder(
          "6.2",
          "Whether g(f_lin) captures more of " + detector + " than Eq 6.2",
          "g(f_lin) > Eq 6.2",
          r2(detector, "lin") > r2(detector, FitResult.CAMSIM)
              ? "g(f_lin) > Eq 6.2"
              : "Eq 6.2 > g(f_lin)");
    }
    if (detectors.contains("orb")) {
      double best = METHODS.stream().mapToDouble(f -> r2("orb", f)).max().orElseThrow();
      addShare(
          "9.1",
          "What the best f captures less of the confidence of orb than measured PIP",
          0.06,
          r2("orb", FitResult.GROUND_TRUTH) - best);
    }
  }

  /** Returns the claims in the order of the text. */
  List<Claim> all() {
    return all;
  }

  /** Writes the claims as a table. */
  void write(OutputFolder folder) throws IOException {
    folder.write(FILE, COLUMNS.csv(all));
  }

  /** Returns the R2 of a detector's line on a predictor. */
  private double r2(String detector, String predictor) {
    return result.line(detector, predictor).r2();
  }

  /** Whether a difference from a published share counts as reproduced. */
  static boolean isReproduced(double difference) {
    return Math.abs(difference) <= TOLERANCE + ROUNDING;
  }

  /** Adds a claim on the value of a share. */
  private void addShare(String source, String text, double published, double yours) {
    all.add(
        new Claim(
            source,
            text,
            Texts.format("%.2f", published),
            Texts.format("%.2f", yours),
            isReproduced(yours - published)));
  }

  /** Adds a claim on the order of names by their values, highest first. */
  private void addOrder(
      String source,
      String text,
      List<String> names,
      ToDoubleFunction<String> published,
      ToDoubleFunction<String> yours) {
    addOrder(source, text, inOrder(names, published), inOrder(names, yours));
  }

  private void addOrder(String source, String text, String published, String yours) {
    all.add(new Claim(source, text, published, yours, published.equals(yours)));
  }

  /** Returns the names in order of their values, highest first. */
  private static String inOrder(List<String> names, ToDoubleFunction<String> value) {
    return names.stream()
        .sorted(Comparator.comparingDouble(value).reversed())
        .collect(Collectors.joining(" > "));
  }

  private static double number(Map<String, String> row, String column) {
    return Double.parseDouble(row.get(column));
  }

  /**
   * A statement of the thesis, and the corresponding result on this data set.
   *
   * @param source the section or table of the thesis
   * @param published the published number or order
   * @param yours the number or order on this data set
   */
  record Claim(String source, String text, String published, String yours, boolean reproduced) {
    String verdict() {
      return reproduced ? "reproduced" : "not reproduced";
    }
  }
}
