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

/** The types of detector model that JSON files may hold, with the range of each number. */
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
                          any(g, "floor"), above0(g, "rise"), above0(g, "scale"))),
              new Format<>(
                  "hill",
                  HillCurve.class,
                  g ->
                      new HillCurve(
                          any(g, "floor"),
                          above0(g, "rise"),
                          above0(g, "half"),
                          above0(g, "exponent"))),
              new Format<>(
                  "logistic",
                  LogisticCurve.class,
                  g -> new LogisticCurve(above0(g, "half"), above0(g, "exponent"))),
              new Format<>("isotonic", IsotonicCurve.class, DetectorFormats::isotonic)));

  private DetectorFormats() {}

  static DetectorModel read(JsonObject json) {
    return ALL.read(json);
  }

  /** The properties of a model; in the oldest version, whose lines have no type, without it. */
  static ObjectNode json(DetectorModel g, int version) {
    ObjectNode json = ALL.json(g);
    if (version == ModelFormat.LINES_ALONE) {
      json.remove("type");
    }
    return json;
  }

  static DetectorLine line(JsonObject json) {
    return new DetectorLine(any(json, "slope"), any(json, "intercept"));
  }

  private static IsotonicCurve isotonic(JsonObject json) {
    double[][] knots =
        json.rows("knots", 2, MAX_KNOTS, -ModelFormat.STEEPEST, ModelFormat.STEEPEST);
    try {
      return new IsotonicCurve(knots);
    } catch (IllegalArgumentException e) {
      throw json.error("knots", e.getMessage());
    }
  }

  private static double any(JsonObject json, String key) {
    return json.number(key, -ModelFormat.STEEPEST, ModelFormat.STEEPEST);
  }

  private static double above0(JsonObject json, String key) {
    return json.number(key, SMALLEST, LARGEST);
  }
}
