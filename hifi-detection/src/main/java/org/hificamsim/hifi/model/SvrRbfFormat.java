package org.hificamsim.hifi.model;

import com.fasterxml.jackson.core.JsonGenerator;
import java.io.IOException;
import org.hificamsim.hifi.feature.SvrRbfAbstraction;
import org.hificamsim.hifi.feature.SvrRbfAbstraction.Range;
import org.hificamsim.hifi.json.JsonObject;

/**
 * The JSON form of a {@link SvrRbfAbstraction}: {@code gamma}, {@code intercept}, {@code ranges} of
 * q, d and z, and {@code support}, a list of {@code [q, d, z, weight]}.
 */
final class SvrRbfFormat {
  private static final double MAX = 1e6;
  private static final int MAX_VECTORS = 50_000;

  private SvrRbfFormat() {}

  static SvrRbfAbstraction read(JsonObject json) {
    double gamma = json.number("gamma", 1e-9, MAX);
    double intercept = json.number("intercept", -MAX, MAX);
    JsonObject ranges = json.object("ranges");
    Range q = range(ranges.object("q"));
    Range d = range(ranges.object("d"));
    Range z = range(ranges.object("z"));
    ranges.rejectUnknown();
    return new SvrRbfAbstraction(
        gamma, intercept, q, d, z, json.rows("support", 4, MAX_VECTORS, -MAX, MAX));
  }

  static void write(SvrRbfAbstraction f, JsonGenerator json) throws IOException {
    json.writeNumberField("gamma", f.gamma());
    json.writeNumberField("intercept", f.intercept());
    json.writeObjectFieldStart("ranges");
    write("q", f.q(), json);
    write("d", f.d(), json);
    write("z", f.z(), json);
    json.writeEndObject();
    json.writeArrayFieldStart("support");
    for (double[] row : f.support()) {
      json.writeArray(row, 0, row.length);
    }
    json.writeEndArray();
  }

  private static Range range(JsonObject json) {
    Range range = new Range(json.number("least", 0, 1000), json.number("most", 0, 1000));
    if (!(range.most() > range.least())) {
      throw json.error("most", "expected more than least, " + range.least());
    }
    json.rejectUnknown();
    return range;
  }

  private static void write(String key, Range range, JsonGenerator json) throws IOException {
    json.writeObjectFieldStart(key);
    json.writeNumberField("least", range.least());
    json.writeNumberField("most", range.most());
    json.writeEndObject();
  }
}
