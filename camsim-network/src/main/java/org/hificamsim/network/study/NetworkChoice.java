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
 * The networks that a study compares.
 *
 * @param strategies the strategies that cameras may have, 1 or more
 * @param bandits the bandits that cameras may have
 * @param alphas the weights of utility against messages for bandits, each in [0, 1]
 */
public record NetworkChoice(
    List<Strategy> strategies, List<BanditAlgorithm> bandits, List<Double> alphas) {
  private static final int MAX_NETWORKS = 1_000_000;

  /** Returns, for each strategy, the network whose cameras all have it. */
  public List<StudyPlan> homogeneous(RunPlan base) {
    return strategies.stream().map(strategy -> plan(base, List.of(strategy))).toList();
  }

  /**
   * Returns a network for each bandit and alpha; its cameras start with the strategies of the file.
   */
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
   * Returns every network whose cameras do not all have the same strategy.
   *
   * @throws InputException if there are more than a million
   */
  public List<StudyPlan> all(RunPlan base) {
    if (count(base) > MAX_NETWORKS) {
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
   * Returns distinct networks whose cameras do not all have the same strategy, drawn with the seed
   * of the plan.
   *
   * @param size the number of networks, 1 or more; all are returned if there are no more
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

  /** Returns the digits of a number in base {@code strategies.size()}, one for each camera. */
  private List<Integer> digits(int number, int cameras) {
    List<Integer> digits = new ArrayList<>();
    for (int rest = number; digits.size() < cameras; rest /= strategies.size()) {
      digits.add(rest % strategies.size());
    }
    return digits;
  }

  /** The number of networks, including the homogeneous ones. */
  double count(RunPlan base) {
    return Math.pow(strategies.size(), cameras(base));
  }

  static int cameras(RunPlan base) {
    return base.scenario().cameras().size();
  }

  /** Returns the network with these strategies, one for each camera or one for all. */
  StudyPlan plan(RunPlan base, List<Strategy> cameraStrategies) {
    boolean isUniform = cameraStrategies.stream().distinct().count() == 1;
    List<Strategy> used = isUniform ? cameraStrategies.subList(0, 1) : cameraStrategies;
    return new StudyPlan(
        base.withNetwork(NetworkText.of(used)),
        isUniform ? StudyPlan.Kind.HOMOGENEOUS : StudyPlan.Kind.HETEROGENEOUS,
        Strategy.text(used));
  }
}
