package org.hificamsim.network.study;

import static org.hificamsim.core.NamedSetting.setting;

import java.util.ArrayList;
import java.util.LinkedHashSet;
import java.util.List;
import java.util.Set;
import java.util.SplittableRandom;
import org.hificamsim.core.InputException;
import org.hificamsim.network.Strategy;
import org.hificamsim.network.bandit.BanditAlgorithm;
import org.hificamsim.network.files.NetworkText;
import org.hificamsim.runs.RunPlan;

/**
 * The networks that a study has.
 *
 * @param strategies that cameras may have, 1 or more
 * @param bandits that cameras may choose by
 * @param alphas weights of utility against messages for bandits, each in [0, 1]
 */
public record NetworkChoice(
    List<Strategy> strategies, List<BanditAlgorithm> bandits, List<Double> alphas) {
  private static final int MAX_ALL = 1_000_000;

  /** A network in which all cameras have one strategy, for each strategy. */
  public List<StudyPlan> homogeneous(RunPlan base) {
    return strategies.stream().map(one -> plan(base, List.of(one))).toList();
  }

  /** A network for each bandit and alpha; its cameras start with what the file says. */
  public List<StudyPlan> bandits(RunPlan base) {
    List<StudyPlan> plans = new ArrayList<>();
    for (BanditAlgorithm bandit : bandits) {
      for (double alpha : alphas) {
        String network = NetworkText.of(bandit, alpha);
        String label = bandit.names().get(0) + "@" + alpha;
        plans.add(new StudyPlan(base.withNetwork(network), StudyPlan.Kind.BANDIT, label));
      }
    }
    return plans;
  }

  /**
   * Every network whose cameras do not all have one strategy.
   *
   * @throws InputException when there are more than a million
   */
  public List<StudyPlan> all(RunPlan base) {
    if (count(base) > MAX_ALL) {
      throw InputException.of(
          "scenario '%s' has %s cameras, %s networks: expected %s or search:N",
          base.scenario().name(), cameras(base), count(base), setting("heterogeneous", "sample:N"));
    }
    List<StudyPlan> plans = new ArrayList<>();
    for (int number = 0; number < count(base); number++) {
      add(plans, base, digits(number, cameras(base)));
    }
    return plans;
  }

  /**
   * Some of them, drawn with the seed of the plan: each once; all where there are no more.
   *
   * @param size how many, 1 or more
   */
  public List<StudyPlan> sample(RunPlan base, int size) {
    if (count(base) - strategies.size() <= size) {
      return all(base);
    }
    SplittableRandom random = new SplittableRandom(base.seed());
    Set<List<Integer>> drawn = new LinkedHashSet<>();
    List<StudyPlan> plans = new ArrayList<>();
    while (plans.size() < size) {
      List<Integer> genes = random.ints(cameras(base), 0, strategies.size()).boxed().toList();
      if (drawn.add(genes)) {
        add(plans, base, genes);
      }
    }
    return plans;
  }

  private void add(List<StudyPlan> plans, RunPlan base, List<Integer> genes) {
    StudyPlan plan = plan(base, genes.stream().map(strategies::get).toList());
    if (plan.kind() == StudyPlan.Kind.HETEROGENEOUS) {
      plans.add(plan);
    }
  }

  /** A number's digits, one for each camera. */
  private List<Integer> digits(int number, int cameras) {
    List<Integer> digits = new ArrayList<>();
    for (int rest = number; digits.size() < cameras; rest /= strategies.size()) {
      digits.add(rest % strategies.size());
    }
    return digits;
  }

  /** How many networks there are, the homogeneous ones included. */
  double count(RunPlan base) {
    return Math.pow(strategies.size(), cameras(base));
  }

  static int cameras(RunPlan base) {
    return base.scenario().cameras().size();
  }

  /** The network of these strategies, one for each camera or one for all. */
  StudyPlan plan(RunPlan base, List<Strategy> each) {
    boolean alike = each.stream().distinct().count() == 1;
    List<Strategy> used = alike ? each.subList(0, 1) : each;
    return new StudyPlan(
        base.withNetwork(NetworkText.of(used)),
        alike ? StudyPlan.Kind.HOMOGENEOUS : StudyPlan.Kind.HETEROGENEOUS,
        Strategy.text(used));
  }
}
