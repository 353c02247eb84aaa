package org.hificamsim.hifi.model;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.List;
import java.util.Optional;
import java.util.regex.Pattern;
import org.hificamsim.hifi.FittedDetection;
import org.hificamsim.hifi.FittedOn;
import org.hificamsim.hifi.FittedOn.Span;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.Provenance;
import org.hificamsim.hifi.Residuals;
import org.hificamsim.hifi.boxes.BoxDetection;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.hifi.feature.FeatureAbstraction;
import org.hificamsim.hifi.json.JsonObject;
import org.hificamsim.hifi.optics.Optics;

/** Reads and writes a {@link FittedDetection} as JSON, and checks the range of each number. */
final class ModelFormat {
  static final List<String> LENGTHS = List.of("q", "d", "z");
  static final double MAX_COEFFICIENT = 1000;

  /** The version in which every g is a line. */
  static final int LINES_ONLY = 1;

  /** The first version in which the scatter of residuals may grow with g. */
  private static final int GROWING_SCATTER = 3;

  /** The version of models of detectors that draw boxes. */
  private static final int BOXES = 4;

  private static final String SCHEMA = "hificamsim-model";
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9:._-]{0,99}");
  private static final double MIN_RMSE = 1e-9;
  private static final double MAX_LENGTH = 1e5;
  private static final int MAX_OBJECTS = 1_000_000;

  private ModelFormat() {}

  static FittedDetection read(JsonObject json) {
    int version = version(json, SCHEMA, LINES_ONLY, 2, GROWING_SCATTER, BOXES);
    return version == BOXES
        ? BoxModelFormat.read(name(json), json)
        : readHiFi(name(json), version, json);
  }

  private static HiFiDetection readHiFi(String name, int version, JsonObject json) {
    refuseCovariates(json);
    FeatureAbstraction f = json.object("f", FeatureFormats::read);
    Fitted g = json.object("g", detector -> fitted(detector, version));
    Optics optics = opticsOrDefault(json);
    double threshold =
        json.has("threshold") ? threshold(json) : PublishedModels.published().threshold(g.model());
    checkUnits(json);
    Optional<FittedOn> fittedOn =
        version > LINES_ONLY && json.has("fitted")
            ? Optional.of(json.object("fitted", ModelFormat::fittedOn))
            : Optional.empty();
    return new HiFiDetection(
        name, f, g.model(), optics, threshold, g.residuals(), fittedOn, provenance(json));
  }

  /**
   * Returns the properties of a model.
   *
   * @throws IllegalArgumentException if there is no format for its class
   */
  static ObjectNode json(FittedDetection model) {
    ObjectNode json = ModelFiles.MAPPER.createObjectNode().put("schema", SCHEMA);
    if (model instanceof HiFiDetection hiFi) {
      write(hiFi, json);
    } else if (model instanceof BoxDetection boxes) {
      json.put("version", BOXES).put("name", model.name());
      BoxModelFormat.write(boxes, json);
      json.putPOJO("provenance", boxes.provenance().remarks());
    } else {
      throw new IllegalArgumentException("no file format for " + model.getClass().getName());
    }
    return json;
  }

  private static void write(HiFiDetection model, ObjectNode json) {
    int version = oldestVersion(model);
    json.put("version", version).put("name", model.name());
    json.set("f", FeatureFormats.json(model.f()));
    ObjectNode g = json.putObject("g").setAll(DetectorFormats.json(model.g(), version));
    model.residuals().ifPresent(residuals -> write(residuals, g));
    json.putPOJO("optics", model.optics());
    json.put("threshold", model.defaultThreshold());
    model.fitted().ifPresent(fittedOn -> json.putPOJO("fitted", fittedOn));
    ObjectNode units = json.putObject("units");
    LENGTHS.forEach(length -> units.put(length, "m"));
    json.putPOJO("provenance", model.provenance().remarks());
  }

  /**
   * Returns the oldest version that can hold the model, so that files of older models keep their
   * bytes.
   */
  private static int oldestVersion(HiFiDetection model) {
    if (model.residuals().filter(Residuals::grow).isPresent()) {
      return GROWING_SCATTER;
    }
    return model.g() instanceof DetectorLine && model.fitted().isEmpty() ? LINES_ONLY : 2;
  }

  private static void write(Residuals residuals, ObjectNode g) {
    g.put("rmse", residuals.rmse());
    if (residuals.grow()) {
      g.putPOJO("scatter", residuals);
    }
  }

  /**
   * Rejects models of earlier versions of the simulator, whose confidence depends on conditions.
   */
  private static void refuseCovariates(JsonObject json) {
    if (json.has("covariates")) {
      throw json.error("covariates", "expected none: such models are no longer supported");
    }
  }

  static int version(JsonObject json, String schema, Integer... versions) {
    json.text("schema", List.of(schema));
    return json.exactly("version", List.of(versions));
  }

  /** A detector model, and how confidences scatter about it if that is known. */
  private record Fitted(DetectorModel model, Optional<Residuals> residuals) {}

  private static Fitted fitted(JsonObject json, int version) {
    DetectorModel model =
        version == LINES_ONLY ? DetectorFormats.line(json) : DetectorFormats.read(json);
    boolean grows = version >= GROWING_SCATTER && json.has("scatter");
    return new Fitted(model, grows ? Optional.of(growingResiduals(json)) : residuals(json));
  }

  static Optional<Residuals> residuals(JsonObject json) {
    return json.has("rmse")
        ? Optional.of(Residuals.of(json.number("rmse", MIN_RMSE, MAX_COEFFICIENT)))
        : Optional.empty();
  }

  private static Residuals growingResiduals(JsonObject json) {
    double rmse = json.number("rmse", MIN_RMSE, MAX_COEFFICIENT);
    return json.object(
        "scatter",
        scatter ->
            new Residuals(
                rmse,
                scatter.number("least", MIN_RMSE, MAX_COEFFICIENT),
                scatter.number("growth", 0, MAX_COEFFICIENT)));
  }

  static Optics opticsOrDefault(JsonObject json) {
    return json.has("optics") ? optics(json) : PublishedModels.published().optics();
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
    return json.number("threshold", -MAX_COEFFICIENT, MAX_COEFFICIENT);
  }

  static Provenance provenance(JsonObject json) {
    return json.has("provenance")
        ? new Provenance(json.object("provenance", JsonObject::texts))
        : Provenance.UNKNOWN;
  }

  static FittedOn fittedOn(JsonObject json) {
    return new FittedOn(
        json.object("q", size -> span(size, MAX_LENGTH)),
        json.object("d", distance -> span(distance, MAX_LENGTH)),
        json.object("z", focalLength -> span(focalLength, MAX_LENGTH)),
        json.count("objects", MAX_OBJECTS),
        json.number("betweenObjects", 0, MAX_COEFFICIENT),
        json.number("withinObjects", 0, MAX_COEFFICIENT));
  }

  static Span span(JsonObject json, double greatest) {
    Span span = new Span(json.number("least", 0, greatest), json.number("most", 0, greatest));
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
      json.object(
          "units",
          units -> LENGTHS.stream().map(length -> units.text(length, List.of("m"))).toList());
    }
  }
}
