package org.hificamsim.network.study;

import static java.util.stream.Collectors.groupingBy;
import static java.util.stream.Collectors.toList;

import java.util.Arrays;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.function.IntToDoubleFunction;
import java.util.function.Predicate;
import java.util.stream.IntStream;
import org.hificamsim.runs.Estimate;
import org.hificamsim.runs.Metric;
import org.hificamsim.runs.RunPlan;

/**
 * The networks of one scenario under one detection, each with its mean utility and cost. Intervals
 * are computed by the jackknife over seeds: each figure is recomputed without one of them.
 */
public final class StudyGroup {
  /** The sets of networks whose fronts are compared. */
  public enum Members {
    HOMOGENEOUS(kind -> kind == StudyPlan.Kind.HOMOGENEOUS),
    /** Networks of strategies that never change, the same for all cameras or not. */
    STATIC(kind -> kind != StudyPlan.Kind.BANDIT),
    BANDIT(kind -> kind == StudyPlan.Kind.BANDIT),
    ADAPTIVE(kind -> kind != StudyPlan.Kind.HETEROGENEOUS),
    ALL(kind -> true);

    @SuppressWarnings("ImmutableEnumChecker") // a function
    private final Predicate<StudyPlan.Kind> includes;

    Members(Predicate<StudyPlan.Kind> includes) {
      this.includes = includes;
    }
  }

  private static final int NO_SEED = -1;

  private final List<StudyPlan> plans;

  /** The utility by network and seed. */
  private final double[][] utility;

  /** The cost by network and seed. */
  private final double[][] cost;

  /** Sums over the seeds, so that leaving one out is cheap. */
  private final double[] utilitySums;

  private final double[] costSums;
  private final Means means;

  /** The means of all networks over seeds. */
  private record Means(double[] utility, double[] cost, double mostUtility, double mostCost) {}

  private StudyGroup(List<StudyPlan> plans, double[][] utility, double[][] cost) {
    this.plans = plans;
    this.utility = utility;
    this.cost = cost;
    this.utilitySums = sums(utility);
    this.costSums = sums(cost);
    this.means = means(NO_SEED);
  }

  /** Returns the groups of a study, in the order of its plans. */
  public static List<StudyGroup> of(StudyResults results) {
    return IntStream.range(0, results.plans().size())
        .boxed()
        .collect(groupingBy(i -> name(results, i), LinkedHashMap::new, toList()))
        .values()
        .stream()
        .map(
            networks ->
                new StudyGroup(
                    networks.stream().map(results.plans()::get).toList(),
                    values(results, networks, Metric.UTILITY),
                    values(results, networks, Metric.MESSAGES)))
        .toList();
  }

  private static List<String> name(StudyResults results, int network) {
    RunPlan plan = results.plans().get(network).plan();
    return List.of(plan.scenario().name(), plan.detection().name());
  }

  private static double[][] values(StudyResults results, List<Integer> networks, Metric metric) {
    return networks.stream().map(i -> results.values(i, metric)).toArray(double[][]::new);
  }

  private static double[] sums(double[][] values) {
    return Arrays.stream(values).mapToDouble(row -> Arrays.stream(row).sum()).toArray();
  }

  private Means means(int leftOutSeed) {
    double[] meanUtility = means(utility, utilitySums, leftOutSeed);
    double[] meanCost = means(cost, costSums, leftOutSeed);
    return new Means(
        meanUtility,
        meanCost,
        Arrays.stream(meanUtility).max().orElse(0),
        Arrays.stream(meanCost).max().orElse(0));
  }

  private static double[] means(double[][] values, double[] sums, int leftOutSeed) {
    double[] means = new double[values.length];
    for (int i = 0; i < means.length; i++) {
      means[i] =
          leftOutSeed == NO_SEED
              ? sums[i] / values[i].length
              : (sums[i] - values[i][leftOutSeed]) / (values[i].length - 1);
    }
    return means;
  }

  /** The networks. */
  public List<StudyPlan> plans() {
    return plans;
  }

  /** The plan of the first network, for the scenario and the detection. */
  public RunPlan plan() {
    return plans.get(0).plan();
  }

  /** The indexes of the networks of a set. */
  public int[] members(Members members) {
    return IntStream.range(0, plans.size())
        .filter(i -> members.includes.test(plans.get(i).kind()))
        .toArray();
  }

  Estimate utility(int network) {
    return Estimate.mean(utility[network]);
  }

  Estimate cost(int network) {
    return Estimate.mean(cost[network]);
  }

  /** The mean utility of a network, relative to the largest of all networks. */
  double utilityShare(int network) {
    return share(means.utility[network], means.mostUtility);
  }

  /** The mean cost of a network, relative to the largest of all networks. */
  double costShare(int network) {
    return share(means.cost[network], means.mostCost);
  }

  private static double share(double value, double most) {
    return most == 0 ? 0 : value / most;
  }

  /** The indexes of the networks on the front of a set, by rising cost. */
  public int[] front(Members members) {
    return Front.find(means.utility, means.cost, members(members));
  }

  /** The hypervolume of the front of a set, 0 to 1. */
  public Estimate hypervolume(Members members) {
    return jackknife(leftOutSeed -> area(leftOutSeed, members(members)));
  }

  /** The hypervolume of the front of a set, less that of another set. */
  public Estimate gain(Members members, Members over) {
    return jackknife(
        leftOutSeed -> area(leftOutSeed, members(members)) - area(leftOutSeed, members(over)));
  }

  /** The hypervolume of a single network, 0 to 1. */
  public double area(int network) {
    return area(NO_SEED, network);
  }

  /** The hypervolume of a network, less that of another network. */
  public Estimate areaLead(int network, int over) {
    return jackknife(leftOutSeed -> area(leftOutSeed, network) - area(leftOutSeed, over));
  }

  private double area(int leftOutSeed, int... networks) {
    Means used = leftOutSeed == NO_SEED ? means : means(leftOutSeed);
    return Front.hypervolume(used.utility, used.cost, networks, used.mostUtility, used.mostCost);
  }

  /**
   * The distance of a network below the front of static networks: how much more utility one of them
   * has at no more cost, as a share of the largest utility; negative beyond that front.
   */
  public double belowFront(int network) {
    return Arrays.stream(front(Members.STATIC))
        .filter(rival -> means.cost[rival] <= means.cost[network])
        .mapToDouble(rival -> utilityShare(rival) - utilityShare(network))
        .max()
        .orElse(-utilityShare(network));
  }

  /** The figure for all seeds, with its interval from leaving out each seed in turn. */
  private Estimate jackknife(IntToDoubleFunction figure) {
    double figureOfAll = figure.applyAsDouble(NO_SEED);
    int seeds = utility[0].length;
    if (seeds == 1) {
      return Estimate.single(figureOfAll);
    }
    Estimate pseudo =
        Estimate.mean(
            IntStream.range(0, seeds)
                .mapToDouble(seed -> seeds * figureOfAll - (seeds - 1) * figure.applyAsDouble(seed))
                .toArray());
    return pseudo.plus(figureOfAll - pseudo.mean());
  }
}
