package org.hificamsim.presentation.figures;

import java.awt.Color;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.runs.compare.CaseResult;

/** A colour for each policy: the same in every figure for those of chapter 7. */
public final class PolicyColors {
  private static final String OPTIMAL = "optimal";

  private static final Map<String, Color> KNOWN =
      Map.of(
          OPTIMAL,
          Palette.BLACK,
          "zoom-out",
          Palette.ORANGE,
          "random",
          Palette.PURPLE,
          "epsilon-greedy",
          Palette.BLUE,
          "sarsa",
          Palette.VERMILION,
          "qb-sarsa",
          Palette.GREEN);

  private final Map<String, Color> colors = new LinkedHashMap<>();

  /** Hands out colours; of two policies that differ in options alone, the first has the known. */
  public PolicyColors(List<String> policies) {
    List<Color> free = new ArrayList<>(Palette.LINES);
    policies.stream().distinct().forEach(policy -> colors.put(policy, take(policy, free)));
    int next = 0;
    for (Map.Entry<String, Color> entry : colors.entrySet()) {
      if (entry.getValue() == null) {
        entry.setValue(free.isEmpty() ? Palette.line(next) : free.remove(0));
        next++;
      }
    }
  }

  private static Color take(String policy, List<Color> free) {
    Color color = KNOWN.get(policy.replaceFirst(":.*", ""));
    return color != null && free.remove(color) ? color : null;
  }

  /** The colours of the cases' policies. */
  public static PolicyColors of(List<CaseResult> cases) {
    return new PolicyColors(cases.stream().map(one -> one.plan().policy()).toList());
  }

  /** The same colours, for some of the policies. */
  public PolicyColors(PolicyColors all, List<String> policies) {
    policies.forEach(policy -> colors.put(policy, all.of(policy)));
  }

  /** The colour of a policy that was given at the start. */
  public Color of(String policy) {
    return colors.get(policy);
  }

  /** The colour of a case's policy. */
  public Color of(CaseResult one) {
    return of(one.plan().policy());
  }

  /** The legend, in the order of the policies; the optimum is dashed. */
  public List<LegendEntry> legend() {
    return colors.entrySet().stream()
        .map(entry -> new LegendEntry(entry.getKey(), entry.getValue(), mark(entry.getKey())))
        .toList();
  }

  private static LegendEntry.Mark mark(String policy) {
    return isOptimal(policy) ? LegendEntry.Mark.DASHES : LegendEntry.Mark.LINE;
  }

  static boolean isOptimal(String policy) {
    return policy.equals(OPTIMAL);
  }
}
