package org.hificamsim.hifi.model;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Optional;
import java.util.function.Function;
import java.util.function.Predicate;
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

  /**
   * How one type is spelt.
   *
   * @param type the text of its property {@code type}
   * @param of the class, whose properties Jackson writes
   * @param reader makes one from these properties; those that it does not ask for are refused
   */
  private record Format(
      String type,
      Class<? extends FeatureAbstraction> of,
      Function<JsonObject, FeatureAbstraction> reader) {}

  private static final List<Format> ALL =
      List.of(
          new Format("linear", LinearAbstraction.class, FeatureFormats::linear),
          new Format("symbolic", SymbolicAbstraction.class, FeatureFormats::symbolic),
          new Format("power", PowerLawAbstraction.class, FeatureFormats::power),
          new Format("pinhole", PinholeAbstraction.class, FeatureFormats::pinhole),
          new Format("svr-rbf", SvrRbfAbstraction.class, SvrRbfFormat::read));

  private FeatureFormats() {}

  static FeatureAbstraction read(JsonObject f) {
    return f.whole(FeatureFormats::feature);
  }

  private static FeatureAbstraction feature(JsonObject json) {
    String type = json.text("type", ALL.stream().map(Format::type).toList());
    return format(one -> one.type().equals(type)).orElseThrow().reader().apply(json);
  }

  static ObjectNode json(FeatureAbstraction f) {
    Format format =
        format(one -> one.of().isInstance(f))
            .orElseThrow(
                () ->
                    new IllegalArgumentException(
                        "no file format for "
                            + f.getClass().getName()
                            + ", expected a line in FeatureFormats"));
    ObjectNode json = ModelWriter.MAPPER.createObjectNode().put("type", format.type());
    return json.setAll(ModelWriter.MAPPER.<ObjectNode>valueToTree(f));
  }

  private static Optional<Format> format(Predicate<Format> wanted) {
    return ALL.stream().filter(wanted).findFirst();
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
