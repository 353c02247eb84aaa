package org.hificamsim.acceptance;

import static org.junit.jupiter.api.Assertions.assertEquals;
import static org.junit.jupiter.api.Assertions.assertTrue;

import java.awt.geom.Line2D;
import java.nio.file.Files;
import java.nio.file.Path;
import java.util.ArrayList;
import java.util.Arrays;
import java.util.HashMap;
import java.util.List;
import java.util.Map;
import java.util.stream.IntStream;
import javax.xml.parsers.DocumentBuilderFactory;
import org.apache.commons.math3.distribution.NormalDistribution;
import org.junit.jupiter.api.io.TempDir;
import org.junit.jupiter.params.ParameterizedTest;
import org.junit.jupiter.params.provider.CsvSource;
import org.w3c.dom.Document;
import org.w3c.dom.Element;
import org.w3c.dom.NodeList;

/**
 * Checks the files of runs by chance with an independent implementation of reader, geometry, model
 * and rule.
 */
class ChanceCheckerTest {
  private static final int STEPS = 10_000;
  private static final double ALPHA = 0.05;

  /** Eq 5.2, and its scatter: the root of the published SSE over 424 degrees of freedom. */
  private static final double SLOPE = 0.60;

  private static final double INTERCEPT = 0.02;
  private static final double RMSE = 0.0423;

  private static final NormalDistribution NORMAL = new NormalDistribution(0, 1);

  @TempDir Path folder;

  private Document site;
  private final List<double[][]> walls = new ArrayList<>();
  private final Map<String, Element> cameras = new HashMap<>();
  private final Map<Double, Double> sizes = new HashMap<>();

  /** The number of detections is within 3.3 standard deviations of its expectation. */
  @ParameterizedTest
  @CsvSource({"car-park, 11", "corridor, 3", "warehouse, 7"})
  void detectionsMatchIndependentExpectation(String name, int targets) throws Exception {
    Path out = folder.resolve(name);
    Cli run =
        Cli.run(
            "run",
            Cli.scenario(name),
            "--detection",
            "hifi:orb-pinhole",
            "--detect",
            "chance",
            "--objective",
            "kmin",
            "--policy",
            "random",
            "--steps",
            STEPS,
            "--record",
            "--out",
            out);
    assertEquals(0, run.exit(), run.err());
    read(Cli.scenario(name));
    assertEquals(targets, sizes.size());
    double expected = 0;
    double variance = 0;
    long drawn = 0;
    Map<String, List<String[]>> seeing = rows(out.resolve("zooms.csv"));
    for (Map.Entry<String, List<String[]>> step : rows(out.resolve("targets.csv")).entrySet()) {
      for (String[] target : step.getValue()) {
        drawn += Long.parseLong(target[5]);
        for (String[] camera : seeing.get(step.getKey())) {
          double chance = chance(camera, target);
          expected += chance;
          variance += chance * (1 - chance);
        }
      }
    }
    assertTrue(expected > 1000, name + " has enough to see: " + expected);
    assertEquals(expected, drawn, 3.3 * Math.sqrt(variance), name);
  }

  /** Returns the rows of a table by step. */
  private static Map<String, List<String[]>> rows(Path table) throws Exception {
    Map<String, List<String[]>> rows = new HashMap<>();
    for (String line : Files.readAllLines(table).subList(1, Files.readAllLines(table).size())) {
      String[] cells = line.split(",");
      rows.computeIfAbsent(cells[1], step -> new ArrayList<>()).add(cells);
    }
    return rows;
  }

  private void read(Path file) throws Exception {
    site = DocumentBuilderFactory.newInstance().newDocumentBuilder().parse(file.toFile());
    for (Element polygon : all("polygon")) {
      walls.add(
          Arrays.stream(polygon.getAttribute("points").split(" "))
              .map(p -> Arrays.stream(p.split(",")).mapToDouble(Double::parseDouble).toArray())
              .toArray(double[][]::new));
    }
    all("camera").forEach(camera -> cameras.put(camera.getAttribute("name"), camera));
    for (Element target :
        all("*").stream().filter(element -> element.hasAttribute("width")).toList()) {
      double area = number(target, "width") * number(target, "height");
      sizes.put(number(target, target.hasAttribute("name") ? "name" : "features"), Math.sqrt(area));
    }
  }

  private List<Element> all(String name) {
    NodeList nodes = site.getElementsByTagName(name);
    return IntStream.range(0, nodes.getLength()).mapToObj(i -> (Element) nodes.item(i)).toList();
  }

  private static double number(Element element, String attribute) {
    return Double.parseDouble(element.getAttribute(attribute));
  }

  /**
   * Returns the chance for rows with the columns run, step, camera, level, radius, detected, pan,
   * angle, moving; and target, x, y.
   */
  private double chance(String[] row, String[] target) {
    Element camera = cameras.get(row[2]);
    double dx = Double.parseDouble(target[3]) - number(camera, "x");
    double dy = Double.parseDouble(target[4]) - number(camera, "y");
    double angle = Math.toRadians(Double.parseDouble(row[7]));
    double ahead = Math.toRadians(number(camera, "heading") + Double.parseDouble(row[6]));
    double off = Math.IEEEremainder(Math.atan2(dx, dy) - ahead, 2 * Math.PI);
    boolean sees = row[8].equals("0") && Math.abs(off) <= angle / 2;
    if (!sees || isHidden(number(camera, "x"), number(camera, "y"), dx, dy)) {
      return 0;
    }
    double zoom = 0.0224 / (2 * Math.tan(angle / 2));
    double share = zoom * sizes.get(Double.valueOf(target[2])) / Math.hypot(dx, dy);
    double confidence = INTERCEPT + SLOPE * Math.min(1, share * share / (0.0224 * 0.015));
    double threshold = INTERCEPT + NORMAL.inverseCumulativeProbability(1 - ALPHA) * RMSE;
    double reaches = 1 - NORMAL.cumulativeProbability((threshold - confidence) / RMSE);
    return Math.max(0, (reaches - ALPHA) / (1 - ALPHA));
  }

  private boolean isHidden(double x, double y, double dx, double dy) {
    for (double[][] wall : walls) {
      for (int i = 0; i < wall.length; i++) {
        double[] from = wall[i];
        double[] to = wall[(i + 1) % wall.length];
        if (Line2D.linesIntersect(x, y, x + dx, y + dy, from[0], from[1], to[0], to[1])) {
          return true;
        }
      }
    }
    return false;
  }
}
