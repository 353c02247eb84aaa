package org.hificamsim.reproduction;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.hificamsim.network.study.StudyGroup;
import org.hificamsim.network.study.StudyGroup.Members;
import org.hificamsim.reproduction.Statements.Margin;

/**
 * Judges what two papers find in CamSim's studies of strategies: Esterle, Lewis, Yao and Rinner
 * (ACM TOSN 10(2), 2014) and Lewis, Esterle, Chandra, Rinner, Torresen and Yao (ACM TAAS 10(2),
 * 2015).
 */
public final class StudyStatements {
  private StudyStatements() {}

  /** Those that a study has the networks for, by its scenarios. */
  public static List<Judged> judged(List<StudyGroup> groups) {
    return Statement.read("study-statements.json").stream()
        .filter(one -> !margins(one, groups).isEmpty())
        .map(one -> Statements.judged(one, margins(one, groups), one.remark()))
        .toList();
  }

  private static List<Margin> margins(Statement one, List<StudyGroup> groups) {
    return switch (one.id()) {
      case "heterogeneous-extend" -> gains(groups, Members.STATIC, Members.HOMOGENEOUS, 0);
      case "bandits-near" -> gains(groups, Members.BANDIT, Members.STATIC, Verdict.TOLERANCE);
      case "bandits-extend" -> widest(gains(groups, Members.ADAPTIVE, Members.HOMOGENEOUS, 0));
      case "bandits-beyond" -> widest(gains(groups, Members.ALL, Members.STATIC, 0));
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
        .map(
            group ->
                new Margin(group.plan().scenario().name(), group.gain(members, over).plus(slack)))
        .toList();
  }

  /** In each scenario, how far another strategy is ahead of the one that is best over all. */
  private static List<Margin> leads(List<StudyGroup> groups) {
    int best = best(groups, -1);
    return groups.stream()
        .map(
            group -> {
              int rival = best(List.of(group), best);
              String where =
                  "%s, %s over %s"
                      .formatted(
                          group.plan().scenario().name(),
                          group.plans().get(rival).label(),
                          group.plans().get(best).label());
              return new Margin(where, group.lead(rival, best));
            })
        .toList();
  }

  /** The strategy, one of the first networks in every scenario, that alone beats most in all. */
  private static int best(List<StudyGroup> groups, int without) {
    return Arrays.stream(groups.get(0).members(Members.HOMOGENEOUS))
        .filter(one -> one != without)
        .boxed()
        .max(
            Comparator.comparingDouble(
                one -> groups.stream().mapToDouble(group -> group.area(one)).sum()))
        .orElse(without);
  }
}
