package org.hificamsim.profiling.report;

import java.io.IOException;
import java.util.ArrayList;
import java.util.Comparator;
import java.util.List;
import java.util.Map;
import java.util.TreeMap;
import java.util.function.Function;
import java.util.function.ToDoubleFunction;
import java.util.stream.Collectors;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.profiling.dataset.TableLayout;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.measure.Measurement;

/** The statements of chapters 4 to 6 and 9, judged on a data set; shares are R2. */
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

  private final FitResult result;
  private final List<String> detectors;

  Claims(FitResult result) {
    this.result = result;
    this.detectors =
        result.detectors().stream()
            .filter(detector -> !PublishedTables.groundTruthLine(detector).isEmpty())
            .toList();
  }

  /** All that concern the detectors that were measured, in the order of the text. */
  List<Claim> all() {
    List<Claim> all = new ArrayList<>();
    all.add(
        Claim.share(
            "4.3",
            "The skewness of -log10(PIP)",
            -0.009,
            Variable.skewness(
                result.measurements().stream().mapToDouble(Measurement::response).toArray())));
    SECTIONS.keySet().forEach(f -> all.add(feature(f)));
    SECTIONS.keySet().forEach(f -> all.add(folds(f)));
    all.add(
        order(
            "4.6",
            "Of the three methods, which predicts PIP best",
            METHODS,
            f -> number(PublishedTables.feature(f), "r2_cv_mean"),
            f -> result.feature(f).validation().mean()));
    ofEach(all, this::groundTruth);
    if (detectors.size() > 1) {
      all.add(
          order(
              "5.7",
              "Which detector's confidence PIP captures best",
              detectors,
              detector -> number(PublishedTables.groundTruthLine(detector), "r2"),
              detector -> result.line(detector, FitResult.GROUND_TRUTH).r2()));
    }
    ofEach(all, this::combination);
    ofEach(all, this::methodsInOrder);
    ofEach(all, this::camSim);
    ofEach(all, this::aboveCamSim);
    if (detectors.contains("orb")) {
      all.add(lostByPrediction());
    }
    return all;
  }

  private void ofEach(List<Claim> all, Function<String, Claim> claim) {
    detectors.stream().map(claim).forEach(all::add);
  }

  /** Writes them as a table. */
  void write(OutputFolder folder) throws IOException {
    folder.write(FILE, COLUMNS.csv(all()));
  }

  private Claim feature(String f) {
    return Claim.share(
        SECTIONS.get(f),
        "What " + f + " captures of -log10(PIP), in its best fold",
        number(PublishedTables.feature(f), "r2_best"),
        StatUtils.max(result.feature(f).validation().folds()));
  }

  private Claim folds(String f) {
    return Claim.share(
        SECTIONS.get(f),
        "What " + f + " captures of -log10(PIP), in the mean of its folds",
        number(PublishedTables.feature(f), "r2_cv_mean"),
        result.feature(f).validation().mean());
  }

  private Claim lostByPrediction() {
    double best = METHODS.stream().mapToDouble(f -> result.line("orb", f).r2()).max().orElseThrow();
    return Claim.share(
        "9.1",
        "What the best f captures less of the confidence of orb than measured PIP",
        0.06,
        result.line("orb", FitResult.GROUND_TRUTH).r2() - best);
  }

  private Claim groundTruth(String detector) {
    return Claim.share(
        "5.4 to 5.6",
        "What measured PIP captures of the confidence of " + detector,
        number(PublishedTables.groundTruthLine(detector), "r2"),
        result.line(detector, FitResult.GROUND_TRUTH).r2());
  }

  private Claim combination(String detector) {
    return Claim.share(
        "6.1, Table 6.1",
        "What g(f_lin) captures of the confidence of " + detector,
        number(PublishedTables.line(detector, "lin"), "r2"),
        result.line(detector, "lin").r2());
  }

  private Claim methodsInOrder(String detector) {
    return order(
        "6.1, Table 6.1",
        "Which f captures the confidence of " + detector + " best",
        METHODS,
        f -> number(PublishedTables.line(detector, f), "r2"),
        f -> result.line(detector, f).r2());
  }

  private Claim camSim(String detector) {
    return Claim.share(
        "6.2, Table 6.2",
        "What Eq 6.2 captures of the confidence of " + detector,
        number(PublishedTables.camSimLine(detector), "r2"),
        result.line(detector, FitResult.CAMSIM).r2());
  }

  private Claim aboveCamSim(String detector) {
    return Claim.order(
        "6.2",
        "Whether g(f_lin) captures more of " + detector + " than Eq 6.2",
        "g(f_lin) > Eq 6.2",
        result.line(detector, "lin").r2() > result.line(detector, FitResult.CAMSIM).r2()
            ? "g(f_lin) > Eq 6.2"
            : "Eq 6.2 > g(f_lin)");
  }

  private static Claim order(
      String source,
      String text,
      List<String> names,
      ToDoubleFunction<String> published,
      ToDoubleFunction<String> yours) {
    return Claim.order(source, text, inOrder(names, published), inOrder(names, yours));
  }

  /** The names, highest first. */
  private static String inOrder(List<String> names, ToDoubleFunction<String> value) {
    return names.stream()
        .sorted(Comparator.comparingDouble(value).reversed())
        .collect(Collectors.joining(" > "));
  }

  private static double number(Map<String, String> row, String column) {
    return Double.parseDouble(row.get(column));
  }

  /**
   * Something that chapters 4 to 6 say, and what it is on the data set at hand.
   *
   * @param source section or table of the thesis
   * @param published the number or order that it says
   * @param yours the same here
   */
  record Claim(String source, String text, String published, String yours, boolean reproduced) {
    /** How far from a published share yours may be to count as the same, as in Table 8.1. */
    static final double TOLERANCE = 0.05;

    private static final double ROUNDING = 1e-9;

    /** That a share has a value. */
    static Claim share(String source, String text, double published, double yours) {
      return new Claim(
          source,
          text,
          number(published),
          number(yours),
          Math.abs(yours - published) <= TOLERANCE + ROUNDING);
    }

    /** That things stand in an order, each named with its number, highest first. */
    static Claim order(String source, String text, String published, String yours) {
      return new Claim(source, text, published, yours, published.equals(yours));
    }

    String verdict() {
      return reproduced ? "reproduced" : "not reproduced";
    }

    private static String number(double value) {
      return Texts.format("%.2f", value);
    }
  }
}
