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
 * are those of the jackknife over seeds: what a figure would be without one of them.
 */
public final class StudyGroup {
  /** Sets of networks whose fronts are compared. */
  public enum Members {
    HOMOGENEOUS(kind -> kind == StudyPlan.Kind.HOMOGENEOUS),
    /** Of strategies that never change, the same for all cameras or not. */
    STATIC(kind -> kind != StudyPlan.Kind.BANDIT),
    BANDIT(kind -> kind == StudyPlan.Kind.BANDIT),
    ADAPTIVE(kind -> kind != StudyPlan.Kind.HETEROGENEOUS),
    ALL(kind -> true);

    @SuppressWarnings("ImmutableEnumChecker") // a function
    private final Predicate<StudyPlan.Kind> has;

    Members(Predicate<StudyPlan.Kind> has) {
      this.has = has;
    }
  }

  private static final int NO_SEED = -1;

  private final List<StudyPlan> plans;
  private final double[][] utility; // by network and seed
  private final double[][] cost;
  private final double[] utilitySums; // over the seeds, so that leaving one out is cheap
  private final double[] costSums;
  private final Means all;

  /** Means of all networks. */
  private record Means(double[] utility, double[] cost, double mostUtility, double mostCost) {}

  private StudyGroup(List<StudyPlan> plans, double[][] utility, double[][] cost) {
    this.plans = plans;
    this.utility = utility;
    this.cost = cost;
    this.utilitySums = sums(utility);
    this.costSums = sums(cost);
    this.all = means(NO_SEED);
  }

  /** The groups of a study, in its order. */
  public static List<StudyGroup> of(StudyResults results) {
    return IntStream.range(0, results.plans().size())
        .boxed()
        .collect(groupingBy(i -> name(results, i), LinkedHashMap::new, toList()))
        .values()
        .stream()
        .map(
            own ->
                new StudyGroup(
                    own.stream().map(results.plans()::get).toList(),
                    values(results, own, Metric.UTILITY),
                    values(results, own, Metric.MESSAGES)))
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
    return Arrays.stream(values).mapToDouble(one -> Arrays.stream(one).sum()).toArray();
  }

  private Means means(int without) {
    double[] meanUtility = means(utility, utilitySums, without);
    double[] meanCost = means(cost, costSums, without);
    return new Means(
        meanUtility,
        meanCost,
        Arrays.stream(meanUtility).max().orElse(0),
        Arrays.stream(meanCost).max().orElse(0));
  }

  private static double[] means(double[][] values, double[] sums, int without) {
    double[] means = new double[values.length];
    for (int i = 0; i < means.length; i++) {
      means[i] =
          without == NO_SEED
              ? sums[i] / values[i].length
              : (sums[i] - values[i][without]) / (values[i].length - 1);
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

  /** The places of a set's networks. */
  public int[] members(Members members) {
    return IntStream.range(0, plans.size())
        .filter(i -> members.has.test(plans.get(i).kind()))
        .toArray();
  }

  Estimate utility(int network) {
    return Estimate.mean(utility[network]);
  }

  Estimate cost(int network) {
    return Estimate.mean(cost[network]);
  }

  /** Mean utility over the largest of all networks. */
  double utilityShare(int network) {
    return share(all.utility[network], all.mostUtility);
  }

  /** Mean cost over the largest of all networks. */
  double costShare(int network) {
    return share(all.cost[network], all.mostCost);
  }

  private static double share(double value, double most) {
    return most == 0 ? 0 : value / most;
  }

  /** The networks of a set on its front, by rising cost. */
  public int[] front(Members members) {
    return Front.of(all.utility, all.cost, members(members));
  }

  /** What a set's front beats of all that is possible, 0 to 1. */
  public Estimate hypervolume(Members members) {
    return jackknife(without -> area(without, members(members)));
  }

  /** How much more a set's front beats than another's. */
  public Estimate gain(Members members, Members over) {
    return jackknife(without -> area(without, members(members)) - area(without, members(over)));
  }

  /** What a network beats by itself, 0 to 1. */
  public double area(int network) {
    return area(NO_SEED, network);
  }

  /** How much more a network beats than another. */
  public Estimate lead(int network, int over) {
    return jackknife(without -> area(without, network) - area(without, over));
  }

  private double area(int without, int... networks) {
    Means means = without == NO_SEED ? all : means(without);
    return Front.hypervolume(
        means.utility, means.cost, networks, means.mostUtility, means.mostCost);
  }

  /**
   * How far a network is below the front of static networks: the utility, as a share of the
   * largest, that one of them has more at no more cost; below 0 beyond that front.
   */
  public double below(int network) {
    return Arrays.stream(front(Members.STATIC))
        .filter(other -> all.cost[other] <= all.cost[network])
        .mapToDouble(other -> utilityShare(other) - utilityShare(network))
        .max()
        .orElse(-utilityShare(network));
  }

  /** Of all seeds, with the interval that leaving out each of them gives. */
  private Estimate jackknife(IntToDoubleFunction figure) {
    double whole = figure.applyAsDouble(NO_SEED);
    int seeds = utility[0].length;
    if (seeds == 1) {
      return Estimate.single(whole);
    }
    Estimate pseudo =
        Estimate.mean(
            IntStream.range(0, seeds)
                .mapToDouble(seed -> seeds * whole - (seeds - 1) * figure.applyAsDouble(seed))
                .toArray());
    return pseudo.plus(whole - pseudo.mean());
  }
}
