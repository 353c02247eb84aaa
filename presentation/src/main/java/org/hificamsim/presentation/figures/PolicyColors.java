package org.hificamsim.presentation.figures;

import java.awt.Color;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Map;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.LineLook;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.runs.compare.CaseResult;

/**
 * A colour, a mark and dashes for each policy, the same in every figure; the policies of chapter 7
 * keep their colours.
 */
public final class PolicyColors {
  private static final String OPTIMAL = "optimal";
  private static final int MOST_BANDS = 4;
  private static final int BANDS_OF_MANY = 3;

  private static final Map<String, Color> FIXED =
      Map.of(
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

  private final FigureStyle style;
  private final Map<String, LineLook> looks = new LinkedHashMap<>();

  /** Assigns the default colours. */
  public PolicyColors(List<String> policies) {
    this(policies, FigureStyle.DEFAULT);
  }

  /** Assigns colours. If policies differ only in their options, the first gets the fixed colour. */
  public PolicyColors(List<String> policies, FigureStyle style) {
    this.style = style;
    List<String> names = policies.stream().distinct().toList();
    List<Color> free = new ArrayList<>(style.palette());
    free.removeAll(style.colors().values());
    Map<String, Color> colors = new LinkedHashMap<>(style.colors());
    for (String policy : names) {
      colors.computeIfAbsent(policy, unseen -> fixed(unseen, free));
    }
    List<Color> palette = style.palette();
    int next = 0;
    for (String policy : names) {
      Color color = colors.get(policy);
      if (policy.equals(OPTIMAL)) {
        looks.put(policy, LineLook.reference());
        continue;
      }
      if (color == null) {
        color = free.isEmpty() ? palette.get(next % palette.size()) : free.remove(0);
      }
      looks.put(policy, LineLook.of(next++, color));
    }
  }

  /** The colour of a policy of chapter 7, if the palette has it and no other policy took it. */
  private static Color fixed(String policy, List<Color> free) {
    Color color = FIXED.get(policy.replaceFirst(":.*", ""));
    return color != null && free.remove(color) ? color : null;
  }

  /** Assigns colours to the policies of cases. */
  public static PolicyColors of(List<CaseResult> cases) {
    return of(cases, FigureStyle.DEFAULT);
  }

  static PolicyColors of(List<CaseResult> cases, FigureStyle style) {
    return new PolicyColors(cases.stream().map(result -> result.plan().policy()).toList(), style);
  }

  /** Takes the colours of some policies from another assignment, in this order. */
  public PolicyColors(PolicyColors other, List<String> policies) {
    style = other.style;
    policies.forEach(policy -> looks.put(policy, other.looks.get(policy)));
  }

  /** The colour of a policy. */
  public Color of(String policy) {
    return looks.get(policy).color();
  }

  /** The look of a case's policy. */
  public LineLook of(CaseResult result) {
    return look(result.plan().policy());
  }

  LineLook look(String policy) {
    return looks.get(policy);
  }

  /** The name of a policy or detection for people. */
  String name(String spec) {
    return style.name(spec);
  }

  /** The legend, in the order of the policies; the optimum is dashed. */
  public List<LegendEntry> legend() {
    return looks.entrySet().stream()
        .map(entry -> LegendEntry.of(name(entry.getKey()), entry.getValue()))
        .toList();
  }

  /** The elements with bands: all, or the first where many bands would cover each other. */
  static <T> List<T> banded(List<T> elements) {
    return elements.size() > MOST_BANDS ? elements.subList(0, BANDS_OF_MANY) : elements;
  }

  /** The words after "bands" that say which of so many lines have one. */
  static String wordsOfBands(int lines) {
    return lines > MOST_BANDS ? ", of the first " + BANDS_OF_MANY + " of the legend" : "";
  }

  static boolean isOptimal(String policy) {
    return policy.equals(OPTIMAL);
  }
}
