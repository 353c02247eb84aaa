package org.hificamsim.hifi.model;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import java.util.List;
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

  private static final List<FeatureFormat<?>> ALL =
      List.of(
          new FeatureFormat<>(
              "linear", LinearAbstraction.class, FeatureFormats::linear, FeatureFormats::write),
          new FeatureFormat<>(
              "symbolic",
              SymbolicAbstraction.class,
              FeatureFormats::symbolic,
              (f, json) -> json.writeStringField("formula", f.expression().toString())),
          new FeatureFormat<>(
              "power", PowerLawAbstraction.class, FeatureFormats::power, FeatureFormats::write),
          new FeatureFormat<>(
              "pinhole", PinholeAbstraction.class, FeatureFormats::pinhole, FeatureFormats::write),
          new FeatureFormat<>(
              "svr-rbf", SvrRbfAbstraction.class, SvrRbfFormat::read, SvrRbfFormat::write));

  private FeatureFormats() {}

  static FeatureAbstraction read(JsonObject json) {
    String type = json.text("type", ALL.stream().map(FeatureFormat::type).toList());
    for (FeatureFormat<?> format : ALL) {
      if (format.type().equals(type)) {
        FeatureAbstraction f = format.reader().read(json);
        json.rejectUnknown();
        return f;
      }
    }
    throw new AssertionError(type);
  }

  static void write(FeatureAbstraction f, JsonGenerator json) throws IOException {
    for (FeatureFormat<?> format : ALL) {
      if (format.of().isInstance(f)) {
        format.write(f, json);
        return;
      }
    }
    throw new IllegalArgumentException(
        "no file format for " + f.getClass().getName() + ", expected a line in FeatureFormats");
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

  private static void write(LinearAbstraction f, JsonGenerator json) throws IOException {
    json.writeNumberField("z", f.z());
    json.writeNumberField("q", f.q());
    json.writeNumberField("d", f.d());
    json.writeNumberField("intercept", f.intercept());
  }

  private static void write(PowerLawAbstraction f, JsonGenerator json) throws IOException {
    json.writeNumberField("c", f.c());
    json.writeNumberField("a", f.a());
    json.writeNumberField("b", f.b());
    json.writeNumberField("e", f.e());
  }

  private static void write(PinholeAbstraction f, JsonGenerator json) throws IOException {
    json.writeNumberField("sensorWidth", f.sensorWidth());
    json.writeNumberField("sensorHeight", f.sensorHeight());
  }

  private static double weight(JsonObject json, String key) {
    return json.number(key, -MAX_WEIGHT, MAX_WEIGHT);
  }

  private static double exponent(JsonObject json, String key) {
    return json.number(key, -MAX_EXPONENT, MAX_EXPONENT);
  }
}
