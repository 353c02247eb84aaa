package org.hificamsim.hifi.model;

import com.fasterxml.jackson.databind.node.ObjectNode;
import org.hificamsim.hifi.feature.Expression;
import org.hificamsim.hifi.feature.FeatureAbstraction;
import org.hificamsim.hifi.feature.LinearAbstraction;
import org.hificamsim.hifi.feature.PinholeAbstraction;
import org.hificamsim.hifi.feature.PowerLawAbstraction;
import org.hificamsim.hifi.feature.SvrRbfAbstraction;
import org.hificamsim.hifi.feature.SymbolicAbstraction;
import org.hificamsim.hifi.json.JsonObject;

/** The types of feature abstraction that JSON files may hold, with the range of each number. */
final class FeatureFormats {
  private static final double MAX_WEIGHT = 1e6;
  private static final double MAX_EXPONENT = 20;
  private static final double MAX_SENSOR = 1;

  private static final FormatTable<FeatureAbstraction> ALL =
      new FormatTable<FeatureAbstraction>()
          .add("linear", LinearAbstraction.class, FeatureFormats::linear)
          .add("symbolic", SymbolicAbstraction.class, FeatureFormats::symbolic)
          .add("power", PowerLawAbstraction.class, FeatureFormats::power)
          .add("pinhole", PinholeAbstraction.class, FeatureFormats::pinhole)
          .add("svr-rbf", SvrRbfAbstraction.class, SvrRbfFormat::read);

  private FeatureFormats() {}

  static FeatureAbstraction read(JsonObject f) {
    return f.whole(ALL::read);
  }

  static ObjectNode json(FeatureAbstraction f) {
    return ALL.json(f);
  }

  static LinearAbstraction linear(JsonObject json) {
    return new LinearAbstraction(
        weight(json, "z"), weight(json, "q"), weight(json, "d"), weight(json, "intercept"));
  }

  private static SymbolicAbstraction symbolic(JsonObject json) {
    String formula = json.text("formula");
    try {
      return new SymbolicAbstraction(Expression.parse(formula));
    } catch (IllegalArgumentException e) {
      throw json.error("formula", e.getMessage());
    }
  }

  private static PowerLawAbstraction power(JsonObject json) {
    return new PowerLawAbstraction(
        json.number("c", Double.MIN_NORMAL, 1e12),
        exponent(json, "a"),
        exponent(json, "b"),
        exponent(json, "e"));
  }

  private static PinholeAbstraction pinhole(JsonObject json) {
    return new PinholeAbstraction(
        json.number("sensorWidth", 1e-6, MAX_SENSOR),
        json.number("sensorHeight", 1e-6, MAX_SENSOR));
  }

  private static double weight(JsonObject json, String key) {
    return json.number(key, -MAX_WEIGHT, MAX_WEIGHT);
  }

  private static double exponent(JsonObject json, String key) {
    return json.number(key, -MAX_EXPONENT, MAX_EXPONENT);
  }
}
