package org.hificamsim.reproduction;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.List;
import java.util.Objects;
import org.hificamsim.core.file.Io;
import org.hificamsim.runs.Metric;

/**
 * Something that the thesis says of the hi-fi model, with the checks on the runs that decide it, or
 * that a paper says of CamSim's strategies.
 *
 * @param source section, table or figure
 * @param remark what to know about the reading; may be empty. With a published number it has a
 *     {@code %.2f} for ours
 * @param role held out unless Table 8.1's hi-fi column implies it, at least in part
 * @param metric what is compared; the mean of k_min unless said otherwise
 * @param published a proportion of the optimum that the text names, or null
 * @param checks empty where {@link DetectionStatements} or {@link StudyStatements} has them
 * @param otherwise or null
 */
record Statement(
    String id,
    String source,
    String text,
    String remark,
    FitRole role,
    Metric metric,
    Double published,
    List<Check> checks,
    Otherwise otherwise) {
  /**
   * The same under another reading of what the thesis leaves open. It is reported, and does not
   * change the verdict, which is that of the defaults.
   *
   * @param reading what is read otherwise, in words
   */
  record Otherwise(String reading, List<Check> checks) {}

  /**
   * A comparison of two cases under the hi-fi model, each {@code scenario/policy}; with {@code *}
   * it is one for each of the six scenarios.
   *
   * @param where what it is about; with {@code *} the scenario's name follows
   * @param more the case that should have more; null for one that has 0
   * @param less null with a published number
   * @param alike whether both should end at the same coverage instead
   */
  record Check(String where, String more, String less, boolean alike) {}

  Statement {
    remark = Objects.requireNonNullElse(remark, "");
    role = Objects.requireNonNullElse(role, FitRole.HELD_OUT);
    metric = Objects.requireNonNullElse(metric, Metric.MEAN_K_MIN);
    checks = checks == null ? List.of() : List.copyOf(checks);
  }

  /** Those of a resource, in the order of the text. */
  static List<Statement> read(String resource) {
    return Io.get(
        () ->
            List.of(
                new ObjectMapper()
                    .readValue(Io.resource(Statement.class, resource), Statement[].class)));
  }
}
