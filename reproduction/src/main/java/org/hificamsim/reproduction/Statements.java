package org.hificamsim.reproduction;

import static org.hificamsim.reproduction.Margins.more;
import static org.hificamsim.reproduction.ReproductionPlans.EPSILON_GREEDY;
import static org.hificamsim.reproduction.ReproductionPlans.OPTIMAL;
import static org.hificamsim.reproduction.ReproductionPlans.QB_SARSA;
import static org.hificamsim.reproduction.ReproductionPlans.SARSA;
import static org.hificamsim.reproduction.ReproductionPlans.STATELESS;
import static org.hificamsim.reproduction.ReproductionPlans.ZOOM_OUT;
import static org.hificamsim.runs.Metric.MEAN_K_MIN;

import java.util.ArrayList;
import java.util.List;
import java.util.Locale;
import java.util.stream.Stream;
import org.hificamsim.reproduction.Statement.Margin;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.compare.Bootstrap;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;

/** What chapter 7 says of the policies, checked under the hi-fi model. */
public final class Statements {
  private static final String SCENARIO_1 = Layout.LATTICE.random();
  private static final String SCENARIO_4 = Layout.LATTICE.scripted();

  private final Margins margins;

  public Statements(Cases cases) {
    margins = new Margins(cases);
  }

  /** All statements, in the order of the text. */
  public List<Statement> all() {
    List<Statement> all = new ArrayList<>(baselines());
    all.addAll(epsilonGreedy());
    all.addAll(sarsa());
    all.addAll(scenarioFour());
    all.addAll(voting());
    all.addAll(overview());
    return all;
  }

  private List<Statement> baselines() {
    var optimum = margins.hifi(SCENARIO_1, OPTIMAL);
    Margin zoomOut = more("zoom-out", optimum, margins.hifi(SCENARIO_1, ZOOM_OUT), MEAN_K_MIN);
    Margin random = more("random", optimum, margins.hifi(SCENARIO_1, "random"), MEAN_K_MIN);
    double[] uncovered = optimum.figures(Metric.COVERED_0);
    Margin always =
        new Margin("scenario 1", Bootstrap.difference(new double[uncovered.length], uncovered));
    return List.of(
        new Statement(
            "greedy-covers-all",
            "7.4.2",
            "Greedy covers every target by at least one camera all the time.",
            List.of(always),
            "the margin is minus the share of targets that no configuration covers"),
        new Statement(
            "baselines-below-greedy",
            "7.4.2, Figure 7.3",
            "Zoom-out and random are considerably weaker than greedy in scenario 1.",
            List.of(zoomOut, random),
            ""));
  }

  private List<Statement> epsilonGreedy() {
    List<Margin> best = new ArrayList<>();
    for (double epsilon : new double[] {0.01, 0.001}) {
      best.addAll(
          margins.inAllSix(EPSILON_GREEDY, ReproductionPlans.epsilon(EPSILON_GREEDY, epsilon)));
    }
    return List.of(
        new Statement(
            "epsilon-0.1-best",
            "7.4.3",
            "Of epsilon 0.1, 0.01 and 0.001, epsilon-greedy does best with 0.1 in all scenarios.",
            best,
            "over 10,000 steps little exploring has time to pay where targets follow a script"),
        new Statement(
            "script-helps",
            "7.4.3, Figure 7.4",
            "Epsilon-greedy comes closer to greedy in scenario 4 than in scenario 1.",
            List.of(
                more(
                    "lattice",
                    margins.hifi(SCENARIO_4, EPSILON_GREEDY),
                    margins.hifi(SCENARIO_1, EPSILON_GREEDY),
                    Metric.PROPORTION_OF_OPTIMAL)),
            ""));
  }

  private List<Statement> sarsa() {
    var low = margins.hifi(SCENARIO_4, SARSA);
    var middle = margins.hifi(SCENARIO_4, ReproductionPlans.epsilon(SARSA, 0.2));
    var high = margins.hifi(SCENARIO_4, ReproductionPlans.epsilon(SARSA, 0.3));
    var two = margins.hifi(SCENARIO_4, ReproductionPlans.alpha(0.2));
    var three = margins.hifi(SCENARIO_4, ReproductionPlans.alpha(0.3));
    var optimum = margins.hifi(SCENARIO_4, OPTIMAL);
    return List.of(
        new Statement(
            "exploring-costs-sarsa",
            "7.4.4, Figure 7.6",
            "SARSA falls as epsilon goes from 0.1 to 0.3.",
            List.of(
                more("0.1 to 0.2", low, middle, MEAN_K_MIN),
                more("0.2 to 0.3", middle, high, MEAN_K_MIN)),
            ""),
        new Statement(
            "alpha-same-end",
            "7.4.4, Figure 7.7",
            "With alpha 0.1, 0.2 and 0.3 SARSA ends at almost the same coverage.",
            Stream.concat(
                    Margins.alike("0.1 and 0.2", low, two, optimum).stream(),
                    Margins.alike("0.1 and 0.3", low, three, optimum).stream())
                .toList(),
            "almost the same: the last tenth's means less than 0.05 of the optimum apart"),
        new Statement(
            "alpha-0.1-faster",
            "7.4.4, Figure 7.7",
            "SARSA converges faster with alpha 0.1 than with 0.2 and 0.3.",
            List.of(
                more("0.1 and 0.2", two, low, Metric.SETTLING_STEPS),
                more("0.1 and 0.3", three, low, Metric.SETTLING_STEPS)),
            "steps until within 90% of the final level"));
  }

  private List<Statement> scenarioFour() {
    var bandit = margins.hifi(SCENARIO_4, EPSILON_GREEDY);
    var sarsa = margins.hifi(SCENARIO_4, SARSA);
    var count = margins.hifi(SCENARIO_4, ReproductionPlans.COUNT);
    return List.of(
        number("epsilon-greedy-81", EPSILON_GREEDY, bandit, PublishedCell.EPSILON_GREEDY_IN_4),
        number("sarsa-87", SARSA, sarsa, PublishedCell.SARSA_IN_4),
        number("sarsa-87-count", ReproductionPlans.COUNT, count, PublishedCell.SARSA_IN_4),
        new Statement(
            "sarsa-above-epsilon-greedy",
            "7.4.4",
            "SARSA does better than epsilon-greedy in scenario 4.",
            List.of(more("scenario 4", sarsa, bandit, MEAN_K_MIN)),
            "contradicts Table 8.1 as well"));
  }

  private static Statement number(String id, String policy, CaseResult one, double published) {
    var ours = Bootstrap.mean(one.figures(Metric.PROPORTION_OF_OPTIMAL));
    return new Statement(
        id,
        "7.4.4",
        String.format(Locale.ROOT, "In scenario 4 %s reaches %.2f of greedy.", policy, published),
        List.of(Margins.near("scenario 4", ours, published)),
        String.format(
            Locale.ROOT, "ours is %.2f; the margin is 0.05 less the distance", ours.mean()));
  }

  private List<Statement> voting() {
    return List.of(
        lessUncovered("qb-sarsa-covers-more", "", "with the default state"),
        lessUncovered("qb-sarsa-covers-more-stateless", STATELESS, "with state=none"),
        settlesSooner("qb-sarsa-faster", "", "with the default state"),
        settlesSooner("qb-sarsa-faster-stateless", STATELESS, "with state=none"),
        higher("qb-sarsa-higher", "", "with the default state"),
        higher("qb-sarsa-higher-stateless", STATELESS, "with state=none"));
  }

  private Statement settlesSooner(String id, String options, String remark) {
    return new Statement(
        id,
        "7.4.5",
        "QB-SARSA converges considerably faster than SARSA in all scenarios.",
        margins.inAllSix(SARSA + options, QB_SARSA + options, Metric.SETTLING_STEPS),
        "steps until within 90% of the final level; " + remark);
  }

  private Statement higher(String id, String options, String remark) {
    return new Statement(
        id,
        "7.5, 7.6",
        "Sharing knowledge (QB-SARSA) gives a higher k_min than SARSA in all scenarios.",
        margins.inAllSix(QB_SARSA + options, SARSA + options),
        remark);
  }

  private Statement lessUncovered(String id, String options, String remark) {
    return new Statement(
        id,
        "7.5, Figure 7.9",
        "QB-SARSA leaves fewer targets uncovered than SARSA in all scenarios.",
        margins.inAllSix(SARSA + options, QB_SARSA + options, Metric.COVERED_0),
        remark);
  }

  private List<Statement> overview() {
    List<Margin> learners = new ArrayList<>();
    List<Margin> script = new ArrayList<>();
    for (String policy : List.of(EPSILON_GREEDY, SARSA, QB_SARSA)) {
      learners.addAll(named(policy, margins.inAllSix(policy, ZOOM_OUT)));
    }
    for (String policy : List.of(ZOOM_OUT, EPSILON_GREEDY, SARSA, QB_SARSA)) {
      for (Layout layout : Layout.values()) {
        script.add(
            more(
                policy + ", " + layout.label(),
                margins.hifi(layout.scripted(), policy),
                margins.hifi(layout.random(), policy),
                MEAN_K_MIN));
      }
    }
    return List.of(
        new Statement(
            "order-of-policies",
            "Table 8.1, 7.5",
            "Greedy is above epsilon-greedy, and epsilon-greedy above SARSA, in all scenarios.",
            Stream.concat(
                    margins.inAllSix(OPTIMAL, EPSILON_GREEDY).stream(),
                    margins.inAllSix(EPSILON_GREEDY, SARSA).stream())
                .toList(),
            ""),
        new Statement(
            "epsilon-greedy-above-zoom-out",
            "Table 8.1",
            "Epsilon-greedy is above zoom-out in all scenarios.",
            margins.inAllSix(EPSILON_GREEDY, ZOOM_OUT),
            ""),
        new Statement(
            "learning-pays",
            "7.5",
            "Even simple learning does substantially better than zoom-out.",
            learners,
            "epsilon-greedy, SARSA and QB-SARSA, in all scenarios"),
        new Statement(
            "zoom-out-not-optimal",
            "7.5, 7.6",
            "The widest zoom everywhere does not give the highest redundancy.",
            margins.inAllSix(OPTIMAL, ZOOM_OUT),
            ""),
        new Statement(
            "scripts-give-more",
            "7.5",
            "Almost all policies give more redundancy in scripted scenarios than in random ones.",
            script,
            "zoom-out, epsilon-greedy, SARSA and QB-SARSA, by layout"));
  }

  private static List<Margin> named(String policy, List<Margin> margins) {
    return margins.stream()
        .map(margin -> new Margin(policy + ", " + margin.where(), margin.value()))
        .toList();
  }
}
