package org.hificamsim.hifi.model;

import java.util.List;
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
    List<Range> qdz = json.object("ranges").whole(SvrRbfFormat::ranges);
    double[][] support = json.rows("support", 4, MAX_VECTORS, -MAX, MAX);
    return new SvrRbfAbstraction(gamma, intercept, qdz.get(0), qdz.get(1), qdz.get(2), support);
  }

  private static List<Range> ranges(JsonObject json) {
    return ModelFormat.LENGTHS.stream()
        .map(name -> json.object(name).whole(SvrRbfFormat::range))
        .toList();
  }

  private static Range range(JsonObject json) {
    Range range = new Range(json.number("least", 0, 1000), json.number("most", 0, 1000));
    if (!(range.most() > range.least())) {
      throw json.error("most", "expected more than least, " + range.least());
    }
    return range;
  }
}
