package org.hificamsim.hifi.model;

import java.util.List;
import java.util.regex.Pattern;
import org.hificamsim.hifi.HiFiDetection;
import org.hificamsim.hifi.Provenance;
import org.hificamsim.hifi.detector.DetectorLine;
import org.hificamsim.hifi.feature.FeatureAbstraction;
import org.hificamsim.hifi.json.JsonObject;
import org.hificamsim.hifi.optics.Optics;

/** Reads the JSON form of a {@link HiFiDetection}, with the range of each number. */
final class ModelFormat {
  static final String SCHEMA = "hificamsim-model";

  static final int VERSION = 1;
  private static final Pattern NAME = Pattern.compile("[A-Za-z0-9][A-Za-z0-9:._-]{0,99}");
  private static final double STEEPEST = 1000;
  static final List<String> LENGTHS = List.of("q", "d", "z");

  private ModelFormat() {}

  static HiFiDetection read(JsonObject json) {
    checkSchema(json, SCHEMA);
    String name = name(json);
    FeatureAbstraction f = FeatureFormats.read(json.object("f"));
    JsonObject line = json.object("g");
    DetectorLine g = detectorLine(line);
    line.rejectUnknown();
    Optics optics =
        json.has("optics") ? optics(json.object("optics")) : PublishedModels.published().optics();
    double threshold =
        json.has("threshold") ? threshold(json) : PublishedModels.published().threshold(g);
    checkUnits(json);
    HiFiDetection model = new HiFiDetection(name, f, g, optics, threshold, provenance(json));
    json.rejectUnknown();
    return model;
  }

  static void checkSchema(JsonObject json, String schema) {
    json.text("schema", List.of(schema));
    json.exactly("version", VERSION);
  }

  static DetectorLine detectorLine(JsonObject json) {
    return new DetectorLine(
        json.number("slope", -STEEPEST, STEEPEST), json.number("intercept", -STEEPEST, STEEPEST));
  }

  static Optics optics(JsonObject json) {
    Optics optics =
        new Optics(
            json.number("sensorWidth", 1e-6, 1), json.number("longestFocalLength", 1e-6, 10));
    json.rejectUnknown();
    return optics;
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
      JsonObject units = json.object("units");
      LENGTHS.forEach(length -> units.text(length, List.of("m")));
      units.rejectUnknown();
    }
  }
}
