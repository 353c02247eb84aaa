package org.hificamsim.hifi.model;

import org.hificamsim.hifi.feature.SvrRbfAbstraction;
import org.hificamsim.hifi.feature.SvrRbfAbstraction.Range;
import org.hificamsim.hifi.json.JsonObject;

/**
 * The JSON form of a {@link SvrRbfAbstraction}: {@code gamma}, {@code intercept}, {@code ranges} of
 * q, d and z, and {@code support}, a list of {@code [q, d, z, weight]}.
 */
final class SvrRbfFormat {
  private static final double LARGEST = 1e6;
  private static final int MOST_VECTORS = 50_000;

  private SvrRbfFormat() {}

  static SvrRbfAbstraction read(JsonObject json) {
    double gamma = json.number("gamma", 1e-9, LARGEST);
    double intercept = json.number("intercept", -LARGEST, LARGEST);
    JsonObject ranges = json.object("ranges");
    Range q = range(ranges.object("q"));
    Range d = range(ranges.object("d"));
    Range z = range(ranges.object("z"));
    ranges.rejectUnknown();
    return new SvrRbfAbstraction(
        gamma, intercept, q, d, z, json.rows("support", 4, MOST_VECTORS, -LARGEST, LARGEST));
  }

  private static Range range(JsonObject json) {
    Range range = new Range(json.number("least", 0, 1000), json.number("most", 0, 1000));
    if (!(range.most() > range.least())) {
      throw json.error("most", "expected more than least, " + range.least());
    }
    json.rejectUnknown();
    return range;
  }
}
