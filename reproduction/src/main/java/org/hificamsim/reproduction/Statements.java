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

/** Judges the statements of the thesis. */
final class Statements {
  /** The last part of a run, whose mean is its final level. */
  private static final double LAST_PART = 0.1;

  private static final String EACH_SCENARIO = "*/";

  /** A figure that has to be above 0, such as the difference between two policies in a scenario. */
  record Margin(String where, Estimate value) {}

  private final Cases cases;
  private final DetectionStatements detections;

  Statements(Cases cases) {
    this.cases = cases;
    this.detections = new DetectionStatements(cases);
  }

  /** All statements, in the order of the text. */
  List<JudgedClaim> judge() {
    return Statement.read("statements.json").stream().map(this::judge).toList();
  }

  private JudgedClaim judge(Statement statement) {
    List<Margin> margins =
        statement.checks().isEmpty()
            ? detections.margins(statement.id())
            : margins(statement, statement.checks());
    return judge(
        statement,
        margins,
        statement.published() == null ? statement.remark() : remarkWithOurs(statement),
        alternative(statement));
  }

  /** Judges a statement by its margins; the remarks that are not empty follow the reason. */
  static JudgedClaim judge(Statement statement, List<Margin> margins, String... remarks) {
    return new JudgedClaim(
        "statement",
        statement.id(),
        statement.source(),
        statement.text(),
        Double.NaN,
        weakest(margins).value(),
        margins.size(),
        held(margins),
        verdict(margins),
        Stream.concat(Stream.of(reason(margins)), Arrays.stream(remarks))
            .filter(reason -> !reason.isEmpty())
            .collect(Collectors.joining("; ")),
        statement.role());
  }

  private static String reason(List<Margin> margins) {
    Margin weakest = weakest(margins);
    return Texts.format(
        "%d of %d checks hold; weakest: %s %s",
        held(margins), margins.size(), weakest.where(), weakest.value().text("%+.3f"));
  }

  /** The result of another reading in words; empty if there is none. */
  private String alternative(Statement statement) {
    if (statement.alternative() == null) {
      return "";
    }
    List<Margin> margins = margins(statement, statement.alternative().checks());
    return statement.alternative().reading()
        + ": "
        + verdict(margins).label()
        + ", "
        + reason(margins);
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

  private String remarkWithOurs(Statement statement) {
    return Texts.format(statement.remark(), proportion(statement.checks().get(0)).mean());
  }

  private List<Margin> margins(Statement statement, List<Check> checks) {
    return checks.stream().flatMap(check -> margins(statement, check)).toList();
  }

  private Stream<Margin> margins(Statement statement, Check check) {
    if (statement.published() != null) {
      return Stream.of(near(check, statement.published()));
    }
    if (check.equal()) {
      return equality(check);
    }
    if (!check.less().startsWith(EACH_SCENARIO)) {
      return Stream.of(difference(check, statement.metric()));
    }
    return Layout.SCENARIOS.stream()
        .map(
            scenario ->
                new Check(
                    check.where() == null ? scenario : check.where() + ", " + scenario,
                    check.more().replace(EACH_SCENARIO, scenario + "/"),
                    check.less().replace(EACH_SCENARIO, scenario + "/"),
                    false))
        .map(scenarioCheck -> difference(scenarioCheck, statement.metric()));
  }

  private Margin difference(Check check, Metric metric) {
    double[] less = find(check.less()).figures(metric);
    double[] more = check.more() == null ? new double[less.length] : figures(check.more(), metric);
    return new Margin(check.where(), Estimate.difference(more, less));
  }

  /** The tolerance of 0.05 minus the distance between our proportion and the published one. */
  private Margin near(Check check, double published) {
    Estimate ours = proportion(check);
    double slack = Verdict.TOLERANCE - Math.abs(ours.mean() - published);
    double half = Math.max(ours.high() - ours.mean(), ours.mean() - ours.low());
    return new Margin(check.where(), new Estimate(slack, slack - half, slack + half));
  }

  private Estimate proportion(Check check) {
    return Estimate.mean(figures(check.more(), Metric.PROPORTION_OF_OPTIMAL));
  }

  /**
   * The tolerance of 0.05 minus the difference of two cases' final proportions, in both directions.
   */
  private Stream<Margin> equality(Check check) {
    double[] difference = finalLevels(find(check.more()));
    double[] others = finalLevels(find(check.less()));
    String scenario = check.more().substring(0, check.more().indexOf('/') + 1);
    double[] optima = finalLevels(find(scenario + OPTIMAL));
    Arrays.setAll(difference, i -> (difference[i] - others[i]) / optima[i]);
    double[] above = Arrays.stream(difference).map(value -> Verdict.TOLERANCE - value).toArray();
    double[] below = Arrays.stream(difference).map(value -> Verdict.TOLERANCE + value).toArray();
    return Stream.of(
        new Margin(check.where() + ", above", Estimate.mean(above)),
        new Margin(check.where() + ", below", Estimate.mean(below)));
  }

  /** The mean k_min over the last tenth of each run. */
  private static double[] finalLevels(CaseResult result) {
    return Arrays.stream(result.partMeans())
        .mapToDouble(
            means ->
                Arrays.stream(means)
                    .skip(means.length - Math.max(1, Math.round(LAST_PART * means.length)))
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
