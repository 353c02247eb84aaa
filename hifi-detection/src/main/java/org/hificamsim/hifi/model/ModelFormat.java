package org.hificamsim.hifi.model;

import com.fasterxml.jackson.databind.ObjectMapper;
import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.hificamsim.hifi.FittedOn;
import org.hificamsim.hifi.FittedOn.Span;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.Provenance;
import org.hificamsim.hifi.Residuals;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.hifi.feature.FeatureAbstraction;
import org.hificamsim.hifi.json.JsonObject;
import org.hificamsim.hifi.optics.Optics;

/**
 * The JSON form of a {@link HiFiDetection}: reads it, with the range of each number, and writes it.
 */
final class ModelFormat {
  static final ObjectMapper MAPPER = new ObjectMapper();
  static final List<String> LENGTHS = List.of("q", "d", "z");
  static final double STEEPEST = 1000;

  /** The version in which every g is a line. */
  static final int LINES_ALONE = 1;

  /** The first version in which residuals may grow. */
  private static final int GROWING = 3;

  private static final String SCHEMA = "hificamsim-model";
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9:._-]{0,99}");
  private static final double MIN_RMSE = 1e-9;
  private static final double LONGEST = 1e5;
  private static final int MAX_OBJECTS = 1_000_000;

  private ModelFormat() {}

  static HiFiDetection read(JsonObject json) {
    int version = version(json, SCHEMA, LINES_ALONE, 2, GROWING);
    refuseCovariates(json);
    String name = name(json);
    FeatureAbstraction f = json.object("f", FeatureFormats::read);
    Fitted g = json.object("g", one -> fitted(one, version));
    Optics optics = json.has("optics") ? optics(json) : PublishedModels.published().optics();
    double threshold =
        json.has("threshold") ? threshold(json) : PublishedModels.published().threshold(g.model());
    checkUnits(json);
    Optional<FittedOn> on =
        version > LINES_ALONE && json.has("fitted")
            ? Optional.of(json.object("fitted", ModelFormat::fittedOn))
            : Optional.empty();
    return new HiFiDetection(
        name, f, g.model(), optics, threshold, g.residuals(), on, provenance(json));
  }

  static ObjectNode json(HiFiDetection model) {
    int version = oldest(model);
    ObjectNode json = MAPPER.createObjectNode().put("schema", SCHEMA).put("version", version);
    json.put("name", model.name());
    json.set("f", FeatureFormats.json(model.f()));
    ObjectNode g = json.putObject("g").setAll(DetectorFormats.json(model.g(), version));
    model.residuals().ifPresent(one -> write(one, g));
    json.putPOJO("optics", model.optics());
    json.put("threshold", model.defaultThreshold());
    model.fitted().ifPresent(on -> json.putPOJO("fitted", on));
    ObjectNode units = json.putObject("units");
    LENGTHS.forEach(length -> units.put(length, "m"));
    return json.putPOJO("provenance", model.provenance().remarks());
  }

  /** The oldest version that can hold the model: what needs no newer one keeps its bytes. */
  private static int oldest(HiFiDetection model) {
    if (model.residuals().filter(Residuals::grow).isPresent()) {
      return GROWING;
    }
    return model.g() instanceof DetectorLine && model.fitted().isEmpty() ? LINES_ALONE : 2;
  }

  private static void write(Residuals residuals, ObjectNode g) {
    g.put("rmse", residuals.rmse());
    if (residuals.grow()) {
      g.putPOJO("scatter", residuals);
    }
  }

  /** Earlier versions of the simulator had models whose confidence depends on conditions. */
  private static void refuseCovariates(JsonObject json) {
    if (json.has("covariates")) {
      throw json.error("covariates", "expected none: such models are no longer supported");
    }
  }

  static int version(JsonObject json, String schema, Integer... versions) {
    json.text("schema", List.of(schema));
    return json.exactly("version", List.of(versions));
  }

  /** A detector model, and how the confidences scatter about it where that is known. */
  private record Fitted(DetectorModel model, Optional<Residuals> residuals) {}

  private static Fitted fitted(JsonObject json, int version) {
    DetectorModel model =
        version == LINES_ALONE ? DetectorFormats.line(json) : DetectorFormats.read(json);
    boolean grows = version >= GROWING && json.has("scatter");
    return new Fitted(model, grows ? Optional.of(growing(json)) : residuals(json));
  }

  static Optional<Residuals> residuals(JsonObject json) {
    return json.has("rmse")
        ? Optional.of(Residuals.of(json.number("rmse", MIN_RMSE, STEEPEST)))
        : Optional.empty();
  }

  private static Residuals growing(JsonObject json) {
    double rmse = json.number("rmse", MIN_RMSE, STEEPEST);
    return json.object(
        "scatter",
        one ->
            new Residuals(
                rmse, one.number("least", MIN_RMSE, STEEPEST), one.number("growth", 0, STEEPEST)));
  }

  static Optics optics(JsonObject json) {
    return json.object(
        "optics",
        optics ->
            new Optics(
                optics.number("sensorWidth", 1e-6, 1),
                optics.number("longestFocalLength", 1e-6, 10)));
  }

  static double threshold(JsonObject json) {
    return json.number("threshold", -STEEPEST, STEEPEST);
  }

  static Provenance provenance(JsonObject json) {
    return json.has("provenance")
        ? new Provenance(json.object("provenance", JsonObject::texts))
        : Provenance.UNKNOWN;
  }

  static FittedOn fittedOn(JsonObject json) {
    return new FittedOn(
        json.object("q", ModelFormat::span),
        json.object("d", ModelFormat::span),
        json.object("z", ModelFormat::span),
        json.count("objects", MAX_OBJECTS),
        json.number("betweenObjects", 0, STEEPEST),
        json.number("withinObjects", 0, STEEPEST));
  }

  private static Span span(JsonObject json) {
    Span span = new Span(json.number("least", 0, LONGEST), json.number("most", 0, LONGEST));
    if (span.most() < span.least()) {
      throw json.error("most", "expected " + span.least() + " or more, the least");
    }
    return span;
  }

  private static String name(JsonObject json) {
    String name = json.text("name");
    if (!NAME.matcher(name).matches()) {
      throw json.error("name", "expected 1 to 100 letters, digits, or any of : . _ -");
    }
    return name;
  }

  private static void checkUnits(JsonObject json) {
    if (json.has("units")) {
      json.object("units", u -> LENGTHS.stream().map(q -> u.text(q, List.of("m"))).toList());
    }
  }
}
