package org.hificamsim.reproduction;

import static org.hificamsim.reproduction.ReproductionPlans.CAMSIM;
import static org.hificamsim.reproduction.ReproductionPlans.EPSILON_GREEDY;
import static org.hificamsim.reproduction.ReproductionPlans.HIFI;
import static org.hificamsim.reproduction.ReproductionPlans.OPTIMAL;
import static org.hificamsim.reproduction.ReproductionPlans.QB_SARSA;
import static org.hificamsim.reproduction.ReproductionPlans.SARSA;
import static org.hificamsim.reproduction.ReproductionPlans.ZOOM_OUT;
import static org.hificamsim.reproduction.ReproductionPlans.alpha;
import static org.hificamsim.reproduction.ReproductionPlans.epsilon;

import java.awt.Color;
import java.io.IOException;
import java.util.ArrayList;
import java.util.List;
import java.util.Map;
import java.util.function.UnaryOperator;
import org.apache.commons.math3.stat.StatUtils;
import org.hificamsim.core.Texts;
import org.hificamsim.core.file.OutputFolder;
import org.hificamsim.presentation.figures.CoverageFigure;
import org.hificamsim.presentation.figures.KMinPanel;
import org.hificamsim.presentation.figures.PolicyColors;
import org.hificamsim.presentation.figures.SpokenNames;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.LineLook;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.hificamsim.runs.compare.CaseResult;
import org.hificamsim.runs.compare.Cases;
import org.knowm.xchart.XYChart;

/** Draws Figures 7.3, 7.4, 7.6 to 7.9 and 8.1 of the thesis with our results. */
public final class ReproductionFigures {
  private static final int WIDTH = 440;
  private static final int HEIGHT = 290;
  private static final int SMALL_WIDTH = 330;
  private static final int SMALL_HEIGHT = 200;
  private static final Color PUBLISHED = Palette.PURPLE;

  private static final List<String> BARS =
      List.of(OPTIMAL, SARSA, QB_SARSA, EPSILON_GREEDY, ZOOM_OUT);

  private static final Map<String, Color> MODELS =
      Map.of(CAMSIM, Palette.BLUE, HIFI, Palette.VERMILION);

  /**
   * A figure of k_min over time.
   *
   * @param scenarios the numbers of the scenarios, each in a panel
   * @param published the proportion of the optimum that the text states for scenario 4, or NaN
   */
  private record TimeFigure(
      String number,
      String title,
      List<Integer> scenarios,
      double published,
      List<String> policies) {}

  private static final List<TimeFigure> OVER_TIME =
      List.of(
          new TimeFigure(
              "7.3",
              "the baselines and greedy, scenario 1",
              List.of(1),
              Double.NaN,
              List.of("random", ZOOM_OUT, OPTIMAL)),
          new TimeFigure(
              "7.4",
              "epsilon-greedy and greedy, random and scripted targets",
              List.of(1, 4),
              PublishedCell.EPSILON_GREEDY_IN_4,
              List.of(EPSILON_GREEDY, OPTIMAL)),
          new TimeFigure(
              "7.6",
              "SARSA's epsilon, scenario 4",
              List.of(4),
              Double.NaN,
              List.of(SARSA, epsilon(SARSA, 0.2), epsilon(SARSA, 0.3), OPTIMAL)),
          new TimeFigure(
              "7.7",
              "SARSA's learning rate, scenario 4",
              List.of(4),
              Double.NaN,
              List.of(SARSA, alpha(0.2), alpha(0.3), OPTIMAL)),
          new TimeFigure(
              "7.8",
              "SARSA and greedy, random and scripted targets",
              List.of(1, 4),
              PublishedCell.SARSA_IN_4,
              List.of(SARSA, OPTIMAL)));

  private final Cases cases;

  public ReproductionFigures(Cases cases) {
    this.cases = cases;
  }

  /** Writes all figures, named by their numbers. */
  public void write(OutputFolder folder) throws IOException {
    for (TimeFigure figure : OVER_TIME) {
      FigureFile.write(folder, "figure-" + figure.number, overTime(figure));
    }
    FigureFile.write(folder, "figure-7.9", figure79());
    FigureFile.write(folder, "figure-8.1", figure81());
    FigureFile.write(folder, "table-8.1", TableFigure.of(new Table81(cases).cells()));
  }

  /** A figure with a panel for each scenario. */
  private Figure overTime(TimeFigure figure) {
    List<CaseResult> results = new ArrayList<>();
    figure.scenarios.forEach(number -> results.addAll(hifi(number, figure.policies)));
    PolicyColors colors = PolicyColors.of(results);
    double most = KMinPanel.ceilingOf(results);
    List<XYChart> panels = new ArrayList<>();
    for (int number : figure.scenarios) {
      List<CaseResult> group = hifi(number, figure.policies);
      KMinPanel panel = KMinPanel.of(title(number), group, colors::of, most);
      if (number == 4 && !Double.isNaN(figure.published)) {
        panel.horizontal(
            figure.published * StatUtils.mean(lastResult(group).meanKMin()), PUBLISHED);
      }
      panels.add(panel);
    }
    List<LegendEntry> legend = new ArrayList<>(colors.legend());
    if (!Double.isNaN(figure.published)) {
      legend.add(
          new LegendEntry(
              Texts.format("published: %.2f of the optimum in scenario 4", figure.published),
              PUBLISHED,
              LegendEntry.Mark.DASHES));
    }
    int width = panels.size() == 1 ? WIDTH + WIDTH / 3 : WIDTH;
    return new Figure(
        "Figure " + figure.number + ": " + figure.title,
        SpokenNames.of(HIFI) + ". " + KMinPanel.note(results),
        legend,
        panels,
        panels.size(),
        width,
        HEIGHT);
  }

  private static CaseResult lastResult(List<CaseResult> group) {
    return group.get(group.size() - 1);
  }

  private Figure figure79() {
    List<CoverageFigure.Group> groups = new ArrayList<>();
    for (int number = 1; number <= Layout.SCENARIOS.size(); number++) {
      groups.add(new CoverageFigure.Group(title(number), hifi(number, BARS)));
    }
    return CoverageFigure.of(
        "Figure 7.9: targets covered by no, one, and more cameras (" + SpokenNames.of(HIFI) + ")",
        groups,
        3,
        UnaryOperator.identity());
  }

  private Figure figure81() {
    List<XYChart> panels = new ArrayList<>();
    for (int number = 1; number <= Layout.SCENARIOS.size(); number++) {
      double most = KMinPanel.ceilingOf(bothModels(number, PublishedCell.POLICIES));
      for (String policy : PublishedCell.POLICIES) {
        panels.add(modelsPanel(number, policy, most));
      }
    }
    return new Figure(
        "Figure 8.1: k_min under the two detection models",
        "By scenario (rows) and policy (columns); x: time (steps), y: k_min (cameras). "
            + KMinPanel.note(bothModels(1, PublishedCell.POLICIES)),
        List.of(
            new LegendEntry(SpokenNames.of(CAMSIM), MODELS.get(CAMSIM), LegendEntry.Mark.LINE),
            new LegendEntry(SpokenNames.of(HIFI), MODELS.get(HIFI), LegendEntry.Mark.LINE)),
        panels,
        PublishedCell.POLICIES.size(),
        SMALL_WIDTH,
        SMALL_HEIGHT);
  }

  private XYChart modelsPanel(int number, String policy, double most) {
    return KMinPanel.of(
            number + ", " + policy,
            bothModels(number, List.of(policy)),
            result -> LineLook.solid(MODELS.get(result.plan().detection().name())),
            most)
        .untitled(); // the note of the figure names the axes
  }

  private List<CaseResult> bothModels(int number, List<String> policies) {
    List<CaseResult> results = new ArrayList<>();
    for (String policy : policies) {
      results.add(cases.find(scenario(number), CAMSIM, policy));
      results.add(cases.find(scenario(number), HIFI, policy));
    }
    return results;
  }

  private List<CaseResult> hifi(int number, List<String> policies) {
    return policies.stream().map(policy -> cases.find(scenario(number), HIFI, policy)).toList();
  }

  private static String scenario(int number) {
    return Layout.SCENARIOS.get(number - 1);
  }

  private static String title(int number) {
    return "Scenario " + number + ", " + scenario(number);
  }

  /** Draws Table 8.1: our proportions as dots, the published ones as diamonds. */
  static final class TableFigure {
    private static final List<Layout> LAYOUTS = List.of(Layout.values());
    private static final int WIDTH = 400;
    private static final int HEIGHT = 290;

    /** The distance of a model's dots from the centre of their layout, in layouts. */
    private static final double MODEL_OFFSET = 0.16;

    private static final double DOT_OFFSET = 0.08;

    private TableFigure() {}

    static Figure of(List<Table81.Cell> cells) {
      return new Figure(
          "Table 8.1: proportion of the greedy approach's performance",
          "Random and scripted scenario of a layout together; bars: 95% intervals over seeds.",
          List.of(
              new LegendEntry("hi-fi, ours", color(true), LegendEntry.Mark.DOT),
              new LegendEntry("hi-fi, published", pale(true), LegendEntry.Mark.DIAMOND),
              new LegendEntry("CamSim, ours", color(false), LegendEntry.Mark.DOT),
              new LegendEntry("CamSim, published", pale(false), LegendEntry.Mark.DIAMOND),
              new LegendEntry("CamSim by Eq 6.2", Palette.GREY, LegendEntry.Mark.DOT)),
          PublishedCell.POLICIES.stream().map(policy -> panel(policy, cells)).toList(),
          PublishedCell.POLICIES.size(),
          WIDTH,
          HEIGHT);
    }

    private static XYChart panel(String policy, List<Table81.Cell> cells) {
      XyPanel panel =
          new XyPanel(policy, "", "proportion of the optimum")
              .y(0, 1)
              .names(LAYOUTS.stream().map(Layout::label).toList())
              .wholeMarks();
      for (Table81.Cell cell : cells) {
        PublishedCell published = cell.published();
        if (published.policy().equals(policy) && !Double.isNaN(cell.ours().mean())) {
          add(panel, cell, published);
        }
      }
      return panel;
    }

    private static void add(XyPanel panel, Table81.Cell cell, PublishedCell published) {
      Color color = color(published.hifi());
      double x =
          LAYOUTS.indexOf(published.layout())
              + 1
              + (published.hifi() ? MODEL_OFFSET : -MODEL_OFFSET);
      panel.interval(x - DOT_OFFSET, cell.ours().low(), cell.ours().high(), color);
      panel.dots(point(x - DOT_OFFSET, cell.ours().mean()), color);
      panel.diamonds(point(x + DOT_OFFSET, published.proportion()), pale(published.hifi()));
      if (!Double.isNaN(cell.proportion(Reading.EQ_62))) {
        panel.dots(point(x - 2 * DOT_OFFSET, cell.proportion(Reading.EQ_62)), Palette.GREY);
      }
    }

    private static Curve point(double x, double y) {
      return new Curve(new double[] {x}, new double[] {y});
    }

    private static Color pale(boolean hifi) {
      return Palette.pale(color(hifi), 0.55);
    }

    private static Color color(boolean hifi) {
      return hifi ? Palette.VERMILION : Palette.BLUE;
    }
  }
}
