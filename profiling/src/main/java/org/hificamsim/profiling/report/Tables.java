package org.hificamsim.profiling.report;

import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import org.hificamsim.profiling.fit.Coefficient;
import org.hificamsim.profiling.fit.FeatureResult;
import org.hificamsim.profiling.fit.FitResult;
import org.hificamsim.profiling.fit.LineFit;
import org.hificamsim.profiling.measure.PipReading;

/** The thesis's tables: yours, and in brackets what is published. */
final class Tables {
  private static final List<String> LINE =
      List.of("R2", "RMSE", "SSE", "slope [95%]", "published", "intercept [95%]", "published");

  private final FitResult result;

  Tables(FitResult result) {
    this.result = result;
  }

  /** Table 4.1. */
  void variables(HtmlPage page) {
    List<List<String>> rows = new ArrayList<>();
    for (Figures.Variable variable : Figures.Variable.of(result)) {
      Moments m = Moments.of(variable.values());
      Map<String, String> published =
          PublishedTables.variables().stream()
              .filter(row -> row.get("variable").equals(variable.id()))
              .findFirst()
              .orElse(Map.of());
      rows.add(
          List.of(
              variable.name(),
              Cells.beside(m.mean(), 3, published, "mean"),
              Cells.beside(m.sd(), 3, published, "sd"),
              Cells.beside(m.min(), 5, published, "min"),
              Cells.beside(m.max(), 3, published, "max"),
              Cells.beside(m.skewness(), 2, published, "skewness")));
    }
    page.table(List.of("variable", "mean", "SD", "min", "max", "skewness"), rows);
  }

  /** Table 4.2, with every f. */
  void features(HtmlPage page) {
    List<List<String>> rows = new ArrayList<>();
    for (FeatureResult f : result.features()) {
      Map<String, String> published = PublishedTables.feature(f.name());
      String theirs =
          published.isEmpty()
              ? ""
              : " (" + published.get("r2_cv_mean") + " +- " + published.get("r2_cv_sd") + ")";
      rows.add(
          List.of(
              f.name(),
              Cells.beside(f.scores().mse(), 3, published, "mse"),
              Cells.beside(f.scores().r2(), 3, published, "r2_best"),
              Cells.fixed(f.scores().rmse(), 3),
              Cells.fixed(f.scores().sse(), 2),
              Cells.fixed(f.validation().mean(), 3)
                  + " +- "
                  + Cells.fixed(f.validation().deviation(), 3)
                  + theirs,
              f.fit().equation(),
              Cells.published(published, "equation")));
    }
    page.table(
        List.of("f", "MSE", "R2", "RMSE", "SSE", "R2 of folds", "yours", "published equation"),
        rows);
  }

  /** Coefficients with standard errors and intervals. */
  void coefficients(HtmlPage page) {
    List<List<String>> rows = new ArrayList<>();
    for (FeatureResult f : result.features()) {
      for (Coefficient c : f.fit().coefficients()) {
        rows.add(
            List.of(
                f.name(),
                c.name(),
                Cells.significant(c.value()),
                Cells.significant(c.error()),
                Cells.span(c.low(), c.high())));
      }
    }
    page.table(List.of("f", "coefficient", "value", "standard error", "95% interval"), rows);
  }

  /** Eqs 5.2 to 5.4. */
  void detectors(HtmlPage page) {
    List<List<String>> rows = new ArrayList<>();
    for (String detector : result.detectors()) {
      LineFit line = result.line(detector, FitResult.GROUND_TRUTH);
      rows.add(line(detector, line, PublishedTables.groundTruthLine(detector)));
    }
    page.table(columns("detector"), rows);
  }

  /** Table 6.1, with every f. */
  void combinations(HtmlPage page) {
    List<List<String>> rows = new ArrayList<>();
    for (String detector : result.detectors()) {
      for (FeatureResult f : result.features()) {
        rows.add(
            line(
                detector + "-" + f.name(),
                result.line(detector, f.name()),
                PublishedTables.line(detector, f.name())));
      }
    }
    page.table(columns("model"), rows);
  }

  /** Table 6.2. */
  void camSim(HtmlPage page) {
    List<List<String>> rows = new ArrayList<>();
    for (String detector : result.detectors()) {
      LineFit line = result.line(detector, FitResult.CAMSIM);
      rows.add(line(detector + "-CamSim", line, PublishedTables.camSimLine(detector)));
    }
    page.table(columns("model"), rows);
  }

  /** Figure 3.7's photos and what every f says of them. */
  void ball(HtmlPage page, HeldOut heldOut) {
    List<String> columns = new ArrayList<>(List.of("f", "RMSE", "bias"));
    heldOut.photos().forEach(o -> columns.add(Math.round(o.focalLength() * 1000) + " mm"));
    List<List<String>> rows = new ArrayList<>();
    List<String> measured = new ArrayList<>(List.of(ballRow(heldOut), "", ""));
    heldOut.photos().forEach(o -> measured.add(Cells.fixed(o.pip(), 4)));
    rows.add(measured);
    for (HeldOut.Check check : heldOut.checks(result)) {
      List<String> row = new ArrayList<>();
      row.add(check.f());
      row.add(Cells.fixed(check.rmse(), 3));
      row.add(Cells.fixed(check.bias(), 3));
      check.pips().forEach(pip -> row.add(Cells.fixed(pip, 4)));
      rows.add(row);
    }
    page.table(columns, rows);
  }

  private static String ballRow(HeldOut heldOut) {
    return heldOut.reading() == PipReading.RECTANGLE
        ? "measured PIP, the ball's rectangle"
        : "measured PIP, the ball's disc";
  }

  /** What chapters 4 to 6 say, judged. */
  void claims(HtmlPage page, List<Claim> claims) {
    page.table(
        List.of("statement", "source", "published", "yours", "verdict"),
        claims.stream()
            .map(
                one ->
                    List.of(one.text(), one.source(), one.published(), one.yours(), one.verdict()))
            .toList());
  }

  private static List<String> columns(String first) {
    List<String> columns = new ArrayList<>(List.of(first));
    columns.addAll(LINE);
    return columns;
  }

  private static List<String> line(String name, LineFit fit, Map<String, String> published) {
    return List.of(
        name,
        Cells.beside(fit.r2(), 3, published, "r2"),
        Cells.beside(fit.rmse(), 4, published, "rmse"),
        Cells.beside(fit.sse(), 2, published, "sse"),
        Cells.interval(fit.slope()),
        Cells.published(published, "slope"),
        Cells.interval(fit.intercept()),
        Cells.published(published, "intercept"));
  }
}
