package org.hificamsim.reproduction;

import static org.hificamsim.reproduction.ReproductionPlans.HIFI;
import static org.hificamsim.reproduction.ReproductionPlans.OPTIMAL;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.Collectors;
import java.util.stream.Stream;
import org.hificamsim.core.Texts;
import org.hificamsim.reproduction.Statement.Check;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;

/** Judges the statements of the text. */
final class Statements {
  private static final double LAST = 0.1;
  private static final String EACH = "*/";

  /** One comparison, such as a difference between two policies in one scenario: to be above 0. */
  record Margin(String where, Estimate value) {}

  private final Cases cases;
  private final DetectionStatements detections;

  Statements(Cases cases) {
    this.cases = cases;
    this.detections = new DetectionStatements(cases);
  }

  /** All statements, in the order of the text. */
  List<Judged> judged() {
    return Statement.read("statements.json").stream().map(this::judged).toList();
  }

  private Judged judged(Statement one) {
    List<Margin> margins =
        one.checks().isEmpty() ? detections.margins(one.id()) : margins(one, one.checks());
    return judged(
        one, margins, one.published() == null ? one.remark() : withOurs(one), otherwise(one));
  }

  /** One that its margins decide; of the remarks to its reason empty ones are left out. */
  static Judged judged(Statement one, List<Margin> margins, String... remarks) {
    return new Judged(
        "statement",
        one.id(),
        one.source(),
        one.text(),
        Double.NaN,
        weakest(margins).value(),
        margins.size(),
        held(margins),
        verdict(margins),
        Stream.concat(Stream.of(reason(margins)), Arrays.stream(remarks))
            .filter(reason -> !reason.isEmpty())
            .collect(Collectors.joining("; ")),
        one.role());
  }

  private static String reason(List<Margin> margins) {
    Margin weakest = weakest(margins);
    return Texts.format(
        "%d of %d checks hold; weakest: %s %s",
        held(margins), margins.size(), weakest.where(), weakest.value().text("%+.3f"));
  }

  /** What another reading finds, in words; empty where there is none. */
  private String otherwise(Statement one) {
    if (one.otherwise() == null) {
      return "";
    }
    List<Margin> margins = margins(one, one.otherwise().checks());
    return one.otherwise().reading() + ": " + verdict(margins).label() + ", " + reason(margins);
  }

  private static Verdict verdict(List<Margin> margins) {
    return Verdict.of(margins.stream().map(Margin::value).toList());
  }

  private static Margin weakest(List<Margin> margins) {
    return margins.stream()
        .min(Comparator.comparingDouble(margin -> margin.value().mean()))
        .orElseThrow();
  }

  private static int held(List<Margin> margins) {
    return (int) margins.stream().filter(margin -> margin.value().mean() > 0).count();
  }

  private String withOurs(Statement one) {
    return Texts.format(one.remark(), proportion(one.checks().get(0)).mean());
  }

  private List<Margin> margins(Statement one, List<Check> checks) {
    return checks.stream().flatMap(check -> margins(one, check)).toList();
  }

  private Stream<Margin> margins(Statement one, Check check) {
    if (one.published() != null) {
      return Stream.of(near(check, one.published()));
    }
    if (check.alike()) {
      return alike(check);
    }
    if (!check.less().startsWith(EACH)) {
      return Stream.of(difference(check, one.metric()));
    }
    return Layout.SCENARIOS.stream()
        .map(
            scenario ->
                new Check(
                    check.where() == null ? scenario : check.where() + ", " + scenario,
                    check.more().replace(EACH, scenario + "/"),
                    check.less().replace(EACH, scenario + "/"),
                    false))
        .map(inOne -> difference(inOne, one.metric()));
  }

  private Margin difference(Check check, Metric metric) {
    double[] less = find(check.less()).figures(metric);
    double[] more = check.more() == null ? new double[less.length] : figures(check.more(), metric);
    return new Margin(check.where(), Estimate.difference(more, less));
  }

  /** What the distance between a proportion and the published one leaves of 0.05. */
  private Margin near(Check check, double published) {
    Estimate ours = proportion(check);
    double slack = Verdict.TOLERANCE - Math.abs(ours.mean() - published);
    double half = Math.max(ours.high() - ours.mean(), ours.mean() - ours.low());
    return new Margin(check.where(), new Estimate(slack, slack - half, slack + half));
  }

  private Estimate proportion(Check check) {
    return Estimate.mean(figures(check.more(), Metric.PROPORTION_OF_OPTIMAL));
  }

  /** By how much less than 0.05 two cases' final proportions differ, either way. */
  private Stream<Margin> alike(Check check) {
    double[] difference = finalLevels(find(check.more()));
    double[] others = finalLevels(find(check.less()));
    String scenario = check.more().substring(0, check.more().indexOf('/') + 1);
    double[] optima = finalLevels(find(scenario + OPTIMAL));
    Arrays.setAll(difference, i -> (difference[i] - others[i]) / optima[i]);
    double[] above = Arrays.stream(difference).map(d -> Verdict.TOLERANCE - d).toArray();
    double[] below = Arrays.stream(difference).map(d -> Verdict.TOLERANCE + d).toArray();
    return Stream.of(
        new Margin(check.where() + ", above", Estimate.mean(above)),
        new Margin(check.where() + ", below", Estimate.mean(below)));
  }

  /** The mean k_min over the last tenth, run by run. */
  private static double[] finalLevels(CaseResult one) {
    return Arrays.stream(one.partMeans())
        .mapToDouble(
            levels ->
                Arrays.stream(levels)
                    .skip(levels.length - Math.max(1, Math.round(LAST * levels.length)))
                    .average()
                    .orElseThrow())
        .toArray();
  }

  private double[] figures(String name, Metric metric) {
    return find(name).figures(metric);
  }

  private CaseResult find(String name) {
    String[] parts = name.split("/", 2);
    return cases.find(parts[0], HIFI, parts[1]);
  }
}
