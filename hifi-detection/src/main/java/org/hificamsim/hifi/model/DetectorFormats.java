package org.hificamsim.hifi.model;

import com.fasterxml.jackson.databind.node.ObjectNode;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.hifi.detector.HillCurve;
import org.hificamsim.hifi.detector.IsotonicCurve;
import org.hificamsim.hifi.detector.LogisticCurve;
import org.hificamsim.hifi.detector.SaturatingExponential;
import org.hificamsim.hifi.json.JsonObject;

/** The types of detector model that JSON files may hold, with the range of each number. */
final class DetectorFormats {
  private static final double SMALLEST = 1e-12;
  private static final double LARGEST = 1e9;
  private static final int MAX_KNOTS = 100_000;

  private static final FormatTable<DetectorModel> ALL =
      new FormatTable<DetectorModel>()
          .add("line", DetectorLine.class, DetectorFormats::line)
          .add("saturating-exponential", SaturatingExponential.class, DetectorFormats::saturating)
          .add("hill", HillCurve.class, DetectorFormats::hill)
          .add("logistic", LogisticCurve.class, DetectorFormats::logistic)
          .add("isotonic", IsotonicCurve.class, DetectorFormats::isotonic);

  private DetectorFormats() {}

  static DetectorModel read(JsonObject json) {
    return ALL.read(json);
  }

  /** The properties of a model; in the oldest version, whose lines have no type, without it. */
  static ObjectNode json(DetectorModel g, int version) {
    return version > ModelFormat.LINES_ALONE ? ALL.json(g) : FormatTable.properties(g);
  }

  static DetectorLine line(JsonObject json) {
    return new DetectorLine(any(json, "slope"), any(json, "intercept"));
  }

  private static SaturatingExponential saturating(JsonObject json) {
    return new SaturatingExponential(any(json, "floor"), rise(json), positive(json, "scale"));
  }

  private static HillCurve hill(JsonObject json) {
    return new HillCurve(
        any(json, "floor"), rise(json), positive(json, "half"), positive(json, "exponent"));
  }

  private static LogisticCurve logistic(JsonObject json) {
    return new LogisticCurve(positive(json, "half"), positive(json, "exponent"));
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

  private static double rise(JsonObject json) {
    return json.number("rise", SMALLEST, LARGEST);
  }

  private static double positive(JsonObject json, String key) {
    return json.number(key, SMALLEST, LARGEST);
  }
}
