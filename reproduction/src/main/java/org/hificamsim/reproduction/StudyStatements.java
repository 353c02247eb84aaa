package org.hificamsim.reproduction;

import java.util.Arrays;
import java.util.Comparator;
import java.util.List;
import org.hificamsim.network.study.StudyGroup;
import org.hificamsim.network.study.StudyGroup.Members;
import org.hificamsim.reproduction.Statements.Margin;

/**
 * Judges the findings of two papers on CamSim's strategies: Esterle, Lewis, Yao and Rinner (ACM
 * TOSN 10(2), 2014) and Lewis, Esterle, Chandra, Rinner, Torresen and Yao (ACM TAAS 10(2), 2015).
 */
public final class StudyStatements {
  private StudyStatements() {}

  /** Judges the statements for which a study has the networks. */
  public static List<JudgedClaim> judge(List<StudyGroup> groups) {
    return Statement.read("study-statements.json").stream()
        .filter(statement -> !margins(statement, groups).isEmpty())
        .map(
            statement ->
                Statements.judge(statement, margins(statement, groups), statement.remark()))
        .toList();
  }

  private static List<Margin> margins(Statement statement, List<StudyGroup> groups) {
    return switch (statement.id()) {
      case "heterogeneous-extend" -> gains(groups, Members.STATIC, Members.HOMOGENEOUS, 0);
      case "bandits-near" -> gains(groups, Members.BANDIT, Members.STATIC, Verdict.TOLERANCE);
      case "bandits-extend" -> largest(gains(groups, Members.ADAPTIVE, Members.HOMOGENEOUS, 0));
      case "bandits-beyond" -> largest(gains(groups, Members.ALL, Members.STATIC, 0));
      case "best-depends" -> groups.size() < 2 ? List.of() : largest(leads(groups));
      default ->
          throw new IllegalArgumentException("statement '" + statement.id() + "' has no checks");
    };
  }

  /** The largest margin, which decides a statement about at least one scenario. */
  private static List<Margin> largest(List<Margin> margins) {
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

  /** The lead of each scenario's best other strategy over the one that is best overall. */
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
              return new Margin(where, group.areaLead(rival, best));
            })
        .toList();
  }

  /** The homogeneous network with the largest area in all scenarios together, except one. */
  private static int best(List<StudyGroup> groups, int excluded) {
    return Arrays.stream(groups.get(0).members(Members.HOMOGENEOUS))
        .filter(strategy -> strategy != excluded)
        .boxed()
        .max(
            Comparator.comparingDouble(
                strategy -> groups.stream().mapToDouble(group -> group.area(strategy)).sum()))
        .orElse(excluded);
  }
}
