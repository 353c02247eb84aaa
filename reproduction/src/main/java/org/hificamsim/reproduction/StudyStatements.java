package org.hificamsim.reproduction;

import static org.hificamsim.network.study.StudyGroup.Members.ADAPTIVE;
import static org.hificamsim.network.study.StudyGroup.Members.ALL;
import static org.hificamsim.network.study.StudyGroup.Members.BANDIT;
import static org.hificamsim.network.study.StudyGroup.Members.HOMOGENEOUS;
import static org.hificamsim.network.study.StudyGroup.Members.STATIC;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.network.study.StudyGroup;
import org.hificamsim.network.study.StudyGroup.Members;
import org.hificamsim.reproduction.Judgement.Judged;
import org.hificamsim.reproduction.Statements.Margin;
import org.hificamsim.runs.Estimate;

/**
 * Judges what two papers find in CamSim's studies of strategies: Esterle, Lewis, Yao and Rinner
 * (ACM TOSN 10(2), 2014) and Lewis, Esterle, Chandra, Rinner, Torresen and Yao (ACM TAAS 10(2),
 * 2015).
 */
public final class StudyStatements {
  private StudyStatements() {}

  /**
   * Those that a study has the networks for.
   *
   * @param groups the study's scenarios
   */
  public static List<Judged> judged(List<StudyGroup> groups) {
    return Statement.read("study-statements.json").stream()
        .filter(one -> !margins(one, groups).isEmpty())
        .map(one -> Statements.judged(one, margins(one, groups), one.remark()))
        .toList();
  }

  private static List<Margin> margins(Statement one, List<StudyGroup> groups) {
    return switch (one.id()) {
      case "heterogeneous-extend" -> gains(groups, STATIC, HOMOGENEOUS, 0);
      case "bandits-near" -> gains(groups, BANDIT, STATIC, Verdict.TOLERANCE);
      case "bandits-extend" -> widest(gains(groups, ADAPTIVE, HOMOGENEOUS, 0));
      case "bandits-beyond" -> widest(gains(groups, ALL, STATIC, 0));
      case "best-depends" -> groups.size() < 2 ? List.of() : widest(leads(groups));
      default -> throw new IllegalArgumentException("statement '" + one.id() + "' has no checks");
    };
  }

  /** What something that is said of some scenarios alone hangs on. */
  private static List<Margin> widest(List<Margin> margins) {
    return margins.stream()
        .max(Comparator.comparingDouble(margin -> margin.value().mean()))
        .stream()
        .toList();
  }

  private static List<Margin> gains(
      List<StudyGroup> groups, Members members, Members over, double slack) {
    return groups.stream()
        .filter(group -> group.members(members).length > 0)
        .filter(group -> !Arrays.equals(group.members(members), group.members(over)))
        .map(group -> new Margin(name(group), plus(slack, group.gain(members, over))))
        .toList();
  }

  private static String name(StudyGroup group) {
    return group.plan().scenario().name();
  }

  private static Estimate plus(double slack, Estimate gain) {
    return new Estimate(gain.mean() + slack, gain.low() + slack, gain.high() + slack);
  }

  /** In each scenario, how far another strategy is ahead of the one that is best over all. */
  private static List<Margin> leads(List<StudyGroup> groups) {
    int best =
        strategies(groups)
            .boxed()
            .max(
                Comparator.comparingDouble(
                    place -> groups.stream().mapToDouble(group -> area(group, place)).sum()))
            .orElseThrow();
    return groups.stream()
        .map(
            group -> {
              int rival =
                  strategies(groups)
                      .filter(place -> place != best)
                      .boxed()
                      .max(Comparator.comparingDouble(place -> area(group, place)))
                      .orElse(best);
              return new Margin(
                  name(group) + ", " + label(group, rival) + " over " + label(group, best),
                  group.lead(network(group, rival), network(group, best)));
            })
        .toList();
  }

  /** The places of homogeneous networks, which have one order in all scenarios. */
  private static IntStream strategies(List<StudyGroup> groups) {
    return IntStream.range(0, groups.get(0).members(HOMOGENEOUS).length);
  }

  private static int network(StudyGroup group, int place) {
    return group.members(HOMOGENEOUS)[place];
  }

  private static String label(StudyGroup group, int place) {
    return group.plans().get(network(group, place)).label();
  }

  private static double area(StudyGroup group, int place) {
    return group.area(network(group, place));
  }
}
