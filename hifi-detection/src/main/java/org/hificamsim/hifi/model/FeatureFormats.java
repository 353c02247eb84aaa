package org.hificamsim.hifi.model;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import org.hificamsim.hifi.feature.Expression;
import org.hificamsim.hifi.feature.FeatureAbstraction;
import org.hificamsim.hifi.feature.LinearAbstraction;
import org.hificamsim.hifi.feature.PinholeAbstraction;
import org.hificamsim.hifi.feature.PowerLawAbstraction;
import org.hificamsim.hifi.feature.SvrRbfAbstraction;
import org.hificamsim.hifi.feature.SvrRbfAbstraction.Range;
import org.hificamsim.hifi.feature.SymbolicAbstraction;
import org.hificamsim.hifi.json.JsonObject;
import org.hificamsim.hifi.model.PartFormats.Format;

/**
 * Reads and writes the types of feature abstraction in JSON files, and checks the range of each
 * number.
 */
final class FeatureFormats {
  private static final double MAX_WEIGHT = 1e6;
  private static final double MAX_EXPONENT = 20;
  private static final double MAX_SENSOR = 1;
  private static final int MAX_VECTORS = 50_000;

  private static final PartFormats<FeatureAbstraction> ALL =
      new PartFormats<>(
          List.of(
              new Format<>("linear", LinearAbstraction.class, FeatureFormats::linear),
              new Format<>("symbolic", SymbolicAbstraction.class, FeatureFormats::symbolic),
              new Format<>("power", PowerLawAbstraction.class, FeatureFormats::power),
              new Format<>("pinhole", PinholeAbstraction.class, FeatureFormats::pinhole),
              new Format<>("svr-rbf", SvrRbfAbstraction.class, FeatureFormats::svrRbf)));

  private FeatureFormats() {}

  static FeatureAbstraction read(JsonObject json) {
    return ALL.read(json);
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

  /** Reads an SVR; {@code support} is a list of {@code [q, d, z, weight]}. */
  private static SvrRbfAbstraction svrRbf(JsonObject json) {
    double gamma = json.number("gamma", 1e-9, MAX_WEIGHT);
    double intercept = weight(json, "intercept");
    List<Range> qdz =
        json.object(
            "ranges",
            ranges ->
                ModelFormat.LENGTHS.stream()
                    .map(length -> ranges.object(length, FeatureFormats::range))
                    .toList());
    double[][] support = json.rows("support", 4, MAX_VECTORS, -MAX_WEIGHT, MAX_WEIGHT);
    return new SvrRbfAbstraction(gamma, intercept, qdz.get(0), qdz.get(1), qdz.get(2), support);
  }

  private static Range range(JsonObject json) {
    Range range = new Range(json.number("least", 0, 1000), json.number("most", 0, 1000));
    if (!(range.most() > range.least())) {
      throw json.error("most", "expected more than least, " + range.least());
    }
    return range;
  }

  private static double weight(JsonObject json, String key) {
    return json.number(key, -MAX_WEIGHT, MAX_WEIGHT);
  }

  private static double exponent(JsonObject json, String key) {
    return json.number(key, -MAX_EXPONENT, MAX_EXPONENT);
  }
}
