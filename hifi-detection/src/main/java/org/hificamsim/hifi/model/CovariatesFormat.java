package org.hificamsim.hifi.model;

import com.fasterxml.jackson.databind.node.ObjectNode;
import java.util.Arrays;
import java.util.List;
import org.hificamsim.core.detection.Condition;
import org.hificamsim.hifi.CovariateTerm;
import org.hificamsim.hifi.FittedOn.Span;
import org.hificamsim.hifi.json.JsonObject;

/**
 * The JSON form of {@link CovariateTerm}s, which may be left out: an object with the name of each
 * condition, which has {@code weight}, {@code mean}, {@code least} and {@code most}.
 */
final class CovariatesFormat {
  private static final String KEY = "covariates";
  private static final double LARGEST = 1e9;
  private static final double MOST_SHIFT = 100;

  private CovariatesFormat() {}

  static List<CovariateTerm> read(JsonObject model) {
    return model.has(KEY) ? model.object(KEY).whole(CovariatesFormat::terms) : List.of();
  }

  private static List<CovariateTerm> terms(JsonObject json) {
    return Arrays.stream(Condition.values())
        .filter(condition -> json.has(condition.key()))
        .map(condition -> json.object(condition.key()).whole(one -> term(condition, one)))
        .toList();
  }

  /** The exponent stays where no double overflows, within what the condition can be. */
  private static CovariateTerm term(Condition condition, JsonObject json) {
    double weight = json.number("weight", -LARGEST, LARGEST);
    Span span = FittedOnFormat.span(json, condition.least(), condition.most());
    double mean = json.number("mean", span.least(), span.most());
    if (Math.abs(weight) * (span.most() - span.least()) > MOST_SHIFT) {
      throw json.error(
          "weight", "expected at most " + MOST_SHIFT + " from the least to the most value");
    }
    return new CovariateTerm(condition, weight, mean, span);
  }

  static void write(ObjectNode model, List<CovariateTerm> terms) {
    if (!terms.isEmpty()) {
      ObjectNode json = model.putObject(KEY);
      terms.forEach(term -> write(json.putObject(term.condition().key()), term));
    }
  }

  private static void write(ObjectNode json, CovariateTerm term) {
    json.put("weight", term.weight()).put("mean", term.mean());
    json.put("least", term.photographed().least()).put("most", term.photographed().most());
  }
}
