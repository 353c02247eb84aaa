package org.hificamsim.hifi.model;

import java.util.List;
import java.util.Optional;
import java.util.OptionalDouble;
import java.util.regex.Pattern;
import org.hificamsim.hifi.FittedOn;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.Provenance;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.hifi.detector.DetectorModel;
import org.hificamsim.hifi.feature.FeatureAbstraction;
import org.hificamsim.hifi.json.JsonObject;
import org.hificamsim.hifi.optics.Optics;

/** Reads the JSON form of a {@link HiFiDetection}, with the range of each number. */
final class ModelFormat {
  static final String SCHEMA = "hificamsim-model";

  /** The version in which every g is a line. */
  static final int LINES_ALONE = 1;

  private static final int NEWEST = 2;
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9:._-]{0,99}");
  static final double STEEPEST = 1000;
  private static final double MIN_RMSE = 1e-9;
  static final List<String> LENGTHS = List.of("q", "d", "z");

  private ModelFormat() {}

  static HiFiDetection read(JsonObject file) {
    return file.whole(ModelFormat::model);
  }

  private static HiFiDetection model(JsonObject json) {
    int version = version(json, SCHEMA, LINES_ALONE, NEWEST);
    refuseCovariates(json);
    String name = name(json);
    FeatureAbstraction f = FeatureFormats.read(json.object("f"));
    Fitted g = json.object("g").whole(one -> fitted(one, version));
    Optics optics = json.has("optics") ? optics(json) : PublishedModels.published().optics();
    double threshold =
        json.has("threshold") ? threshold(json) : PublishedModels.published().threshold(g.model());
    checkUnits(json);
    boolean newer = version > LINES_ALONE;
    Optional<FittedOn> on = newer ? FittedOnFormat.read(json) : Optional.empty();
    return new HiFiDetection(name, f, g.model(), optics, threshold, g.rmse(), on, provenance(json));
  }

  /** Earlier versions of the simulator had models whose confidence depends on conditions. */
  private static void refuseCovariates(JsonObject json) {
    if (json.has("covariates")) {
      throw json.error("covariates", "expected none: such models are no longer supported");
    }
  }

  /** The oldest version that can hold a model: what needs no newer one keeps its bytes. */
  static int version(HiFiDetection model) {
    return model.g() instanceof DetectorLine && model.fitted().isEmpty() ? LINES_ALONE : NEWEST;
  }

  static int version(JsonObject json, String schema, int... versions) {
    json.text("schema", List.of(schema));
    return json.exactly("version", versions);
  }

  /** A detector model, and how the confidences scatter about it where that is known. */
  private record Fitted(DetectorModel model, OptionalDouble rmse) {}

  private static Fitted fitted(JsonObject json, int version) {
    DetectorModel model =
        version == LINES_ALONE ? DetectorFormats.line(json) : DetectorFormats.read(json);
    return new Fitted(model, rmse(json));
  }

  static OptionalDouble rmse(JsonObject json) {
    return json.has("rmse")
        ? OptionalDouble.of(json.number("rmse", MIN_RMSE, STEEPEST))
        : OptionalDouble.empty();
  }

  static Optics optics(JsonObject json) {
    return json.object("optics")
        .whole(
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
        ? new Provenance(json.object("provenance").texts())
        : Provenance.UNKNOWN;
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
      json.object("units")
          .whole(units -> LENGTHS.stream().map(q -> units.text(q, List.of("m"))).toList());
    }
  }
}
