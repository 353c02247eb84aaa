package org.hificamsim.hifi.model;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.hifi.detector.HillCurve;
import org.hificamsim.hifi.detector.IsotonicCurve;
import org.hificamsim.hifi.detector.LogisticCurve;
import org.hificamsim.hifi.detector.SaturatingExponential;
import org.hificamsim.hifi.json.JsonObject;
import org.hificamsim.hifi.model.PartFormats.Format;

/**
 * Reads and writes the types of detector model in JSON files, and checks the range of each number.
 */
final class DetectorFormats {
  private static final double SMALLEST = 1e-12;
  private static final double LARGEST = 1e9;
  private static final int MAX_KNOTS = 100_000;

  private static final PartFormats<DetectorModel> ALL =
      new PartFormats<>(
          List.of(
              new Format<>("line", DetectorLine.class, DetectorFormats::line),
              new Format<>(
                  "saturating-exponential",
                  SaturatingExponential.class,
                  g ->
                      new SaturatingExponential(
                          coefficient(g, "floor"), positive(g, "rise"), positive(g, "scale"))),
              new Format<>(
                  "hill",
                  HillCurve.class,
                  g ->
                      new HillCurve(
                          coefficient(g, "floor"),
                          positive(g, "rise"),
                          positive(g, "half"),
                          positive(g, "exponent"))),
              new Format<>(
                  "logistic",
                  LogisticCurve.class,
                  g -> new LogisticCurve(positive(g, "half"), positive(g, "exponent"))),
              new Format<>("isotonic", IsotonicCurve.class, DetectorFormats::isotonic)));

  private DetectorFormats() {}

  static DetectorModel read(JsonObject json) {
    return ALL.read(json);
  }

  /**
   * Returns the properties of a model. The oldest version has only lines, which are written without
   * their type.
   */
  static ObjectNode json(DetectorModel g, int version) {
    ObjectNode json = ALL.json(g);
    if (version == ModelFormat.LINES_ONLY) {
      json.remove("type");
    }
    return json;
  }

  static DetectorLine line(JsonObject json) {
    return new DetectorLine(coefficient(json, "slope"), coefficient(json, "intercept"));
  }

  private static IsotonicCurve isotonic(JsonObject json) {
    double[][] knots =
        json.rows("knots", 2, MAX_KNOTS, -ModelFormat.MAX_COEFFICIENT, ModelFormat.MAX_COEFFICIENT);
    try {
      return new IsotonicCurve(knots);
    } catch (IllegalArgumentException e) {
      throw json.error("knots", e.getMessage());
    }
  }

  private static double coefficient(JsonObject json, String key) {
    return json.number(key, -ModelFormat.MAX_COEFFICIENT, ModelFormat.MAX_COEFFICIENT);
  }

  private static double positive(JsonObject json, String key) {
    return json.number(key, SMALLEST, LARGEST);
  }
}
