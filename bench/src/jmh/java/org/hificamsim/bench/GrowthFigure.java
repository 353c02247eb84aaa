package org.hificamsim.bench;

import com.fasterxml.jackson.databind.JsonNode;
import com.fasterxml.jackson.databind.ObjectMapper;
import java.awt.Color;
import java.io.File;
import java.io.IOException;
import java.io.OutputStream;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.LinkedHashMap;
import java.util.List;
import java.util.Locale;
import java.util.Map;
import java.util.NavigableMap;
import java.util.TreeMap;
import org.hificamsim.presentation.plot.Curve;
import org.hificamsim.presentation.plot.Figure;
import org.hificamsim.presentation.plot.FigureFile;
import org.hificamsim.presentation.plot.LegendEntry;
import org.hificamsim.presentation.plot.LegendEntry.Mark;
import org.hificamsim.presentation.plot.Palette;
import org.hificamsim.presentation.plot.XyPanel;
import org.knowm.xchart.style.XYStyler;

/**
 * Draws how the cost of a step grows with the network, and prints it as a table, from the results
 * of {@link StepBenchmark} and {@link NetworkGrowthBenchmark}.
 */
public final class GrowthFigure {
  private static final double MICROSECONDS = 1e-3;

  private GrowthFigure() {}

  /**
   * Draws the figure.
   *
   * @param args the JSON file that JMH wrote, and the picture to write
   */
  public static void main(String[] args) throws IOException {
    Map<String, NavigableMap<Integer, Double>> costs = read(new File(args[0]));
    costs.forEach(GrowthFigure::print);
    try (OutputStream out = Files.newOutputStream(Path.of(args[1]))) {
      FigureFile.png(out, figure(costs));
    }
  }

  /** Returns the milliseconds of a step, by policy and number of cameras. */
  private static Map<String, NavigableMap<Integer, Double>> read(File file) throws IOException {
    Map<String, NavigableMap<Integer, Double>> costs = new LinkedHashMap<>();
    for (JsonNode result : new ObjectMapper().readTree(file)) {
      costs
          .computeIfAbsent(name(result.at("/params")), policy -> new TreeMap<>())
          .put(
              cameras(result.at("/params")),
              MICROSECONDS * result.at("/primaryMetric/score").asDouble());
    }
    return costs;
  }

  private static int cameras(JsonNode params) {
    return params.path("randomCameras").asInt(params.path("cameras").asInt());
  }

  private static String name(JsonNode params) {
    return params.path("policy").asText("CamSim's network");
  }

  private static void print(String policy, NavigableMap<Integer, Double> costs) {
    costs.forEach(
        (cameras, cost) -> {
          Integer fewer = costs.lowerKey(cameras);
          double doublings = fewer == null ? 0 : Math.log((double) cameras / fewer) / Math.log(2);
          String growth =
              fewer == null ? "" : number("%.2f", Math.pow(cost / costs.get(fewer), 1 / doublings));
          System.out.printf(
              "%-16s %7d cameras %10s ms a step  %s%n",
              policy,
              cameras,
              number("%.4f", cost),
              growth.isEmpty() ? "" : "x " + growth + " for each doubling");
        });
  }

  private static String number(String format, double value) {
    return String.format(Locale.ROOT, format, value);
  }

  /** Makes both axes logarithmic, with numbers written out and room around the curves. */
  private static void setLogarithmic(XYStyler style) {
    style.setXAxisLogarithmic(true);
    style.setYAxisLogarithmic(true);
    style.setXAxisDecimalPattern("#,##0.###");
    style.setYAxisDecimalPattern("#,##0.###");
    style.setPlotContentSize(0.94);
  }

  private static Figure figure(Map<String, NavigableMap<Integer, Double>> costs) {
    XyPanel panel = new XyPanel("", "cameras", "milliseconds a step");
    setLogarithmic(panel.getStyler());
    List<LegendEntry> legend = new ArrayList<>();
    costs.forEach(
        (policy, costsOfPolicy) -> {
          Color color = Palette.line(legend.size());
          Curve curve = curve(costsOfPolicy);
          panel.straight(curve, color).dots(curve, color);
          legend.add(new LegendEntry(policy, color, Mark.LINE));
        });
    NavigableMap<Integer, Double> first = costs.values().iterator().next();
    panel.dashed(squared(first), Palette.GREY);
    legend.add(new LegendEntry("with the square", Palette.GREY, Mark.DASHES));
    return new Figure(
        "The cost of a step over the size of the network",
        "Random fields of one density, 0.6 targets for each camera (CamSim's network: 0.5), one"
            + " thread",
        legend,
        List.of(panel),
        1,
        560,
        360);
  }

  private static Curve curve(NavigableMap<Integer, Double> costs) {
    return new Curve(
        costs.keySet().stream().mapToDouble(cameras -> cameras).toArray(),
        costs.values().stream().mapToDouble(cost -> cost).toArray());
  }

  /**
   * Returns the curve of a cost that grows with the square, up to where it leaves the other curves.
   */
  private static Curve squared(NavigableMap<Integer, Double> costs) {
    double few = costs.firstKey();
    double many = costs.lastKey();
    double end = Math.min(many, few * Math.sqrt(many / few) * 4);
    return new Curve(
        new double[] {few, end},
        new double[] {
          costs.firstEntry().getValue(), costs.firstEntry().getValue() * Math.pow(end / few, 2)
        });
  }
}
