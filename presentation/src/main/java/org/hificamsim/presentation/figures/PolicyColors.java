package org.hificamsim.presentation.figures;

import java.awt.Color;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.runs.compare.CaseResult;

/** A colour for each policy; the policies of chapter 7 have the same one in every figure. */
public final class PolicyColors {
  private static final String OPTIMAL = "optimal";

  private static final Map<String, Color> FIXED =
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

  /** Assigns colours. If policies differ only in their options, the first gets the fixed colour. */
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
    Color color = FIXED.get(policy.replaceFirst(":.*", ""));
    return color != null && free.remove(color) ? color : null;
  }

  /** Assigns colours to the policies of cases. */
  public static PolicyColors of(List<CaseResult> cases) {
    return new PolicyColors(cases.stream().map(result -> result.plan().policy()).toList());
  }

  /** Takes the colours of some policies from another assignment. */
  public PolicyColors(PolicyColors other, List<String> policies) {
    policies.forEach(policy -> colors.put(policy, other.of(policy)));
  }

  /** The colour of a policy. */
  public Color of(String policy) {
    return colors.get(policy);
  }

  /** The colour of a case's policy. */
  public Color of(CaseResult result) {
    return of(result.plan().policy());
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
