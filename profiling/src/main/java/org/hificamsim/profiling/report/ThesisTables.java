package org.hificamsim.profiling.report;

import static org.hificamsim.profiling.report.CellText.fixed;
import static org.hificamsim.profiling.report.CellText.interval;
import static org.hificamsim.profiling.report.CellText.published;
import static org.hificamsim.profiling.report.CellText.significant;
import static org.hificamsim.profiling.report.CellText.span;
import static org.hificamsim.profiling.report.CellText.withPublished;

import java.util.List;
import java.util.Map;
import java.util.stream.Stream;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.profiling.dataset.TableLayout;
import org.hificamsim.profiling.fit.Coefficient;
import org.hificamsim.profiling.fit.FeatureResult;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.LineFit;
import org.hificamsim.profiling.report.Claims.Claim;

/**
 * Adds the tables of the thesis with the data set's numbers, and the published ones in brackets.
 */
final class ThesisTables {
  private final FitResult result;

  ThesisTables(FitResult result) {
    this.result = result;
  }

  /** Adds Table 4.1. */
  void variables(HtmlPage page) {
    page.table(
        new TableLayout<Variable>()
            .with("variable", Variable::name)
            .with("mean", variable -> cell(variable, StatUtils.mean(variable.values()), 3, "mean"))
            .with("SD", variable -> cell(variable, Variable.sd(variable.values()), 3, "sd"))
            .with("min", variable -> cell(variable, StatUtils.min(variable.values()), 5, "min"))
            .with("max", variable -> cell(variable, StatUtils.max(variable.values()), 3, "max"))
            .with(
                "skewness",
                variable -> cell(variable, Variable.skewness(variable.values()), 2, "skewness")),
        Variable.of(result));
  }

  private static String cell(Variable variable, double value, int digits, String column) {
    return withPublished(value, digits, PublishedTables.variable(variable.id()), column);
  }

  /** Adds Table 4.2, extended to every f. */
  void features(HtmlPage page) {
    page.table(
        new TableLayout<FeatureResult>()
            .with("f", FeatureResult::name)
            .with("MSE", f -> withPublished(f.scores().mse(), 3, publishedRow(f), "mse"))
            .with("R2", f -> withPublished(f.scores().r2(), 3, publishedRow(f), "r2_best"))
            .with("RMSE", f -> fixed(f.scores().rmse(), 3))
            .with("SSE", f -> fixed(f.scores().sse(), 2))
            .with("R2 of folds", ThesisTables::folds)
            .with("yours", f -> f.fit().equation())
            .with("published equation", f -> published(publishedRow(f), "equation")),
        result.features());
  }

  private static Map<String, String> publishedRow(FeatureResult f) {
    return PublishedTables.feature(f.name());
  }

  private static String folds(FeatureResult f) {
    String yours = fixed(f.validation().mean(), 3) + " +- " + fixed(f.validation().deviation(), 3);
    Map<String, String> publishedRow = publishedRow(f);
    return publishedRow.isEmpty()
        ? yours
        : yours
            + " ("
            + publishedRow.get("r2_cv_mean")
            + " +- "
            + publishedRow.get("r2_cv_sd")
            + ")";
  }

  private record CoefficientRow(String f, Coefficient coefficient) {}

  /** Adds the table of coefficients with standard errors and intervals. */
  void coefficients(HtmlPage page) {
    page.table(
        new TableLayout<CoefficientRow>()
            .with("f", CoefficientRow::f)
            .with("coefficient", row -> row.coefficient.name())
            .with("value", row -> significant(row.coefficient.value()))
            .with("standard error", row -> significant(row.coefficient.error()))
            .with("95% interval", row -> span(row.coefficient.low(), row.coefficient.high())),
        result.features().stream()
            .flatMap(f -> f.fit().coefficients().stream().map(c -> new CoefficientRow(f.name(), c)))
            .toList());
  }

  /** A line fitted to a detector's confidences, and the published one. */
  private record LineRow(String name, LineFit fit, Map<String, String> published) {}

  /** Adds the table of detector lines on measured PIP (Eqs 5.2 to 5.4). */
  void detectors(HtmlPage page) {
    lines(
        page,
        "detector",
        result.detectors().stream()
            .map(
                detector ->
                    new LineRow(
                        detector,
                        result.line(detector, FitResult.GROUND_TRUTH),
                        PublishedTables.groundTruthLine(detector))));
  }

  /** Adds Table 6.1, extended to every f. */
  void combinations(HtmlPage page) {
    lines(
        page,
        "model",
        result.detectors().stream()
            .flatMap(
                detector -> result.features().stream().map(f -> combination(detector, f.name()))));
  }

  private LineRow combination(String detector, String f) {
    return new LineRow(
        detector + "-" + f, result.line(detector, f), PublishedTables.line(detector, f));
  }

  /** Adds Table 6.2. */
  void camSim(HtmlPage page) {
    lines(
        page,
        "model",
        result.detectors().stream()
            .map(
                detector ->
                    new LineRow(
                        detector + "-CamSim",
                        result.line(detector, FitResult.CAMSIM),
                        PublishedTables.camSimLine(detector))));
  }

  private static void lines(HtmlPage page, String nameColumn, Stream<LineRow> rows) {
    page.table(
        new TableLayout<LineRow>()
            .with(nameColumn, LineRow::name)
            .with("R2", row -> withPublished(row.fit.r2(), 3, row.published, "r2"))
            .with("RMSE", row -> withPublished(row.fit.rmse(), 4, row.published, "rmse"))
            .with("SSE", row -> withPublished(row.fit.sse(), 2, row.published, "sse"))
            .with("slope [95%]", row -> interval(row.fit.slope()))
            .with("published", row -> published(row.published, "slope"))
            .with("intercept [95%]", row -> interval(row.fit.intercept()))
            .with("published", row -> published(row.published, "intercept")),
        rows.toList());
  }

  /** Adds the table of verdicts on the thesis's statements. */
  static void claims(HtmlPage page, List<Claim> claims) {
    page.table(
        new TableLayout<Claim>()
            .with("statement", Claim::text)
            .with("source", Claim::source)
            .with("published", Claim::published)
            .with("yours", Claim::yours)
            .with("verdict", Claim::verdict),
        claims);
  }
}
