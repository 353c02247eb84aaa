package org.hificamsim.reproduction;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.List;
import java.util.Objects;
import org.hificamsim.core.file.Io;
import org.hificamsim.runs.Metric;

/**
 * A statement of the thesis about the hi-fi model, or of a paper about CamSim's strategies, with
 * the checks of runs that decide whether it is reproduced.
 *
 * @param source section, table or figure
 * @param remark remark about the reading; may be empty. With a published number it has a {@code
 *     %.2f} for our number
 * @param role held out, unless the hi-fi column of Table 8.1 implies the statement at least in part
 * @param metric metric that is compared; by default the mean of k_min
 * @param published a proportion of the optimum that the text states, or null
 * @param checks empty if {@link DetectionStatements} or {@link StudyStatements} has them
 * @param alternative another reading, or null
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
    Alternative alternative) {
  /**
   * The checks under another reading of the thesis where it is open. The result is reported, but
   * the verdict is that of the defaults.
   *
   * @param reading the difference from the defaults, in words
   */
  record Alternative(String reading, List<Check> checks) {}

  /**
   * A comparison of two cases under the hi-fi model, each {@code scenario/policy}; {@code *} stands
   * for each of the six scenarios.
   *
   * @param where the subject of the comparison; with {@code *} the name of the scenario follows
   * @param more the case that should have the higher value; null for the value 0
   * @param less the case that should have the lower value; null with a published number
   * @param equal whether both should end at the same coverage instead
   */
  record Check(String where, String more, String less, boolean equal) {}

  Statement {
    remark = Objects.requireNonNullElse(remark, "");
    role = Objects.requireNonNullElse(role, FitRole.HELD_OUT);
    metric = Objects.requireNonNullElse(metric, Metric.MEAN_K_MIN);
    checks = checks == null ? List.of() : List.copyOf(checks);
  }

  /** Reads the statements of a resource, in the order of the text. */
  static List<Statement> read(String resource) {
    return Io.get(
        () ->
            List.of(
                new ObjectMapper()
                    .readValue(Io.resource(Statement.class, resource), Statement[].class)));
  }
}
