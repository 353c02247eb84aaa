package org.hificamsim.core;

import java.util.List;
import java.util.stream.Stream;

/**
 * A run of CamSim, recorded step by step.
 *
 * @param name the common beginning of the names of its files
 */
public record CamSimTrace(String name, CamSimCommand command) {
  private static final String FOLDER = "camsim/traces/";
  private static final String ALL =
      """
      ICDSC2012-scenario_5__Active__c0__s0__t200 | ICDSC2012/scenario_5.xml \
      | -a active -c 0 -s 0 -t 200
      SASO-360-scenario12_corridor_fail__Passive__c0__s0__t300 \
      | SASO-360/scenario12_corridor_fail.xml | -a passive -c 0 -s 0 -t 300
      SASO-360-scenario6__BanditZoom__c0__s0__t500__bandit-SoftMax | SASO-360/scenario6.xml \
      | -a epics.ai.dynamicZoom.BanditSolverZoom -b epics.bandits.SoftMax -c 0 -s 0 -t 500
      SASO-scenario6__Active__c0__s0__t1000 | SASO/scenario6.xml | -a active -c 0 -s 0 -t 1000
      SASO-scenario6__Active__c0__s1__t500__move-DirectedBrownian | SASO/scenario6.xml \
      | -a active -c 0 -s 1 -t 500 -m epics.movement.DirectedBrownian
      SASO-scenario6__Passive__c1__s2__t500__move-Brownian | SASO/scenario6.xml \
      | -a passive -c 1 -s 2 -t 500 -m Brownian
      """;

  /** Returns all traces; skips the calling test if their files are missing. */
  public static Stream<CamSimTrace> all() {
    Reference.file(FOLDER);
    return ALL.lines().map(CamSimTrace::of);
  }

  private static CamSimTrace of(String line) {
    String[] cells = line.split("\\s*\\|\\s*");
    return new CamSimTrace(cells[0], CamSimCommand.of("camsim/scenarios/" + cells[1], cells[2]));
  }

  /** Returns the rows of {@code positions}, {@code confidences} or {@code owners}. */
  public List<String[]> rows(String table) {
    return Reference.rows(FOLDER + name + "." + table + ".csv");
  }

  @Override
  public String toString() {
    return name;
  }
}
