package org.hificamsim.hifi.model;

import java.util.Optional;
import org.hificamsim.hifi.FittedOn;
import org.hificamsim.hifi.FittedOn.Span;
import org.hificamsim.hifi.json.JsonObject;

/** The JSON form of {@link FittedOn}, which may be left out. */
final class FittedOnFormat {
  private static final double LONGEST = 1e5;
  private static final int MOST_OBJECTS = 1_000_000;

  private FittedOnFormat() {}

  static Optional<FittedOn> read(JsonObject model) {
    return model.has("fitted")
        ? Optional.of(model.object("fitted").whole(FittedOnFormat::fitted))
        : Optional.empty();
  }

  private static FittedOn fitted(JsonObject json) {
    return new FittedOn(
        json.object("q").whole(FittedOnFormat::span),
        json.object("d").whole(FittedOnFormat::span),
        json.object("z").whole(FittedOnFormat::span),
        json.count("objects", MOST_OBJECTS),
        json.number("betweenObjects", 0, ModelFormat.STEEPEST),
        json.number("withinObjects", 0, ModelFormat.STEEPEST));
  }

  private static Span span(JsonObject json) {
    return span(json, 0, LONGEST);
  }

  /** {@code least} and {@code most} of an object, each in a range. */
  static Span span(JsonObject json, double from, double to) {
    double least = json.number("least", from, to);
    double most = json.number("most", from, to);
    if (most < least) {
      throw json.error("most", "expected " + least + " or more, the least");
    }
    return new Span(least, most);
  }
}
