package org.hificamsim.hifi.model;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Optional;
import org.hificamsim.hifi.boxes.BoxDetection;
import org.hificamsim.hifi.boxes.FittedBoxes;
import org.hificamsim.hifi.boxes.FoundCurve;
import org.hificamsim.hifi.boxes.WidthEffect;
import org.hificamsim.hifi.json.JsonObject;

/** Reads and writes a {@link BoxDetection} as JSON, and checks the range of each number. */
final class BoxModelFormat {
  private static final double MAX_FALSE_ALARMS = 1e4;
  private static final double MAX_PIXELS = 1e6;
  private static final double MIN_SHAPE = 0.01;
  private static final double MAX_SHAPE = 100;
  private static final int MAX_COUNT = 1_000_000;

  private BoxModelFormat() {}

  static BoxDetection read(String name, JsonObject json) {
    return new BoxDetection(
        name,
        json.object("found", BoxModelFormat::curve),
        ModelFormat.opticsOrDefault(json),
        json.has("falseAlarms") ? json.number("falseAlarms", 0, MAX_FALSE_ALARMS) : 0,
        json.has("fitted")
            ? Optional.of(json.object("fitted", BoxModelFormat::fitted))
            : Optional.empty(),
        ModelFormat.provenance(json));
  }

  static void write(BoxDetection model, ObjectNode json) {
    write(model.curve(), json.putObject("found"));
    json.put("falseAlarms", model.falseAlarms());
    json.putPOJO("optics", model.optics());
    model.fitted().ifPresent(fitted -> json.putPOJO("fitted", fitted));
  }

  private static void write(FoundCurve curve, ObjectNode json) {
    json.put("intercept", curve.intercept());
    json.put("height", curve.height());
    json.put("hidden", curve.hidden());
    json.put("floor", curve.floor());
    json.put("ceiling", curve.ceiling());
    if (curve.width().counts()) {
      json.putPOJO("width", curve.width());
    }
  }

  private static FoundCurve curve(JsonObject json) {
    double floor = json.has("floor") ? json.number("floor", 0, 1) : 0;
    double ceiling = json.has("ceiling") ? json.number("ceiling", 0, 1) : 1;
    if (ceiling <= floor) {
      throw json.error(
          json.has("ceiling") ? "ceiling" : "floor",
          "expected a ceiling above the floor, " + floor);
    }
    double height = json.number("height", 0, ModelFormat.MAX_COEFFICIENT);
    return new FoundCurve(
        json.number("intercept", -ModelFormat.MAX_COEFFICIENT, ModelFormat.MAX_COEFFICIENT),
        height,
        json.number("hidden", 0, ModelFormat.MAX_COEFFICIENT),
        floor,
        ceiling,
        json.has("width") ? json.object("width", width -> width(width, height)) : WidthEffect.NONE);
  }

  /**
   * Reads the effect of the width. A steeper slope than allowed would make taller people less
   * likely to be found.
   */
  private static WidthEffect width(JsonObject json, double height) {
    return new WidthEffect(
        json.number("slope", 0, height), json.number("usualShape", MIN_SHAPE, MAX_SHAPE));
  }

  private static FittedBoxes fitted(JsonObject json) {
    return new FittedBoxes(
        json.object("height", heights -> ModelFormat.span(heights, MAX_PIXELS)),
        json.object("hidden", shares -> ModelFormat.span(shares, 1)),
        json.count("recordings", MAX_COUNT),
        json.count("people", MAX_COUNT));
  }
}
