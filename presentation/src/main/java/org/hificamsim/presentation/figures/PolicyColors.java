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
 * Assigns a colour, a mark and dashes to each policy, which are the same in every figure. The
 * policies of chapter 7 of the thesis keep their colours.
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

  /**
   * Assigns colours. If policies differ only in their options, the first gets the colour of chapter
   * 7.
   */
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

  /**
   * Takes the colour of a policy of chapter 7 from those that are free; returns null if it cannot.
   */
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

  /** Takes the looks of some policies, in this order, from another assignment. */
  public PolicyColors(PolicyColors other, List<String> policies) {
    style = other.style;
    policies.forEach(policy -> looks.put(policy, other.looks.get(policy)));
  }

  /** The colour of a policy. */
  public Color of(String policy) {
    return looks.get(policy).color();
  }

  /** Returns the colour, mark and dashes of a case's policy. */
  public LineLook of(CaseResult result) {
    return look(result.plan().policy());
  }

  LineLook look(String policy) {
    return looks.get(policy);
  }

  /** Returns the words that people read for a policy or detection. */
  String name(String spec) {
    return style.name(spec);
  }

  /** Returns the legend, in the order of the policies. */
  public List<LegendEntry> legend() {
    return looks.entrySet().stream()
        .map(entry -> LegendEntry.of(name(entry.getKey()), entry.getValue()))
        .toList();
  }

  /** Returns the elements that get bands: all, or the first few if many bands would overlap. */
  static <T> List<T> banded(List<T> elements) {
    return elements.size() > MOST_BANDS ? elements.subList(0, BANDS_OF_MANY) : elements;
  }

  /** Returns the words that follow "bands" if only some of the lines have one. */
  static String wordsOfBands(int lines) {
    return lines > MOST_BANDS ? ", of the first " + BANDS_OF_MANY + " of the legend" : "";
  }

  static boolean isOptimal(String policy) {
    return policy.equals(OPTIMAL);
  }
}
