package org.hificamsim.network;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.Optional;
import java.util.Set;
import org.hificamsim.core.scenario.AgentCheck;
import org.hificamsim.network.agent.HistoricalParameters;
import org.hificamsim.network.agent.ScheduleKind;
import org.hificamsim.network.bandit.BanditAlgorithm;
import org.hificamsim.network.bandit.BanditParameters;

/**
 * How a scenario's network is run, apart from what the scenario itself says (behaviour 12.1).
 *
 * @param schedule for all cameras of the file; else what each camera asks for
 * @param comm policy for all cameras of the file; else what each camera asks for
 * @param bandit for all cameras; else what each camera asks for
 * @param errorLevel the highest of 100 draws at which a camera fails in a step; -1 for never
 * @param resetLevel the highest of 100 draws at which a failing camera keeps its neighbours
 * @param quirks those that are reproduced
 */
public record NetworkSettings(
    Optional<ScheduleKind> schedule,
    Optional<Comm> comm,
    Optional<BanditAlgorithm> bandit,
    GraphUse graph,
    int errorLevel,
    int resetLevel,
    BanditParameters banditParameters,
    HistoricalParameters historicalParameters,
    Set<Quirk> quirks) {
  /** What becomes of a scenario's vision graph: CamSim's option {@code -v} (behaviour 3.6). */
  public enum GraphUse {
    AS_IN_FILE(-1),
    STATIC(0),
    IGNORED(1),
    CHANGING(2);

    private final int number;

    GraphUse(int number) {
      this.number = number;
    }

    /** The use of this number. */
    public static Optional<GraphUse> find(int number) {
      return Arrays.stream(values()).filter(use -> use.number == number).findFirst();
    }

    /** Whether the graph counts as static. */
    boolean isStatic(boolean inFile) {
      return this == STATIC || (this == AS_IN_FILE && inFile);
    }
  }

  /** CamSim's own defaults, and all its quirks. */
  public static final NetworkSettings CAMSIM =
      new NetworkSettings(
          Optional.empty(),
          Optional.empty(),
          Optional.empty(),
          GraphUse.AS_IN_FILE,
          -1,
          50,
          BanditParameters.DEFAULT,
          HistoricalParameters.DEFAULT,
          EnumSet.allOf(Quirk.class));

  /** The same without the quirks that can be left out. */
  public static final NetworkSettings DEFAULT = CAMSIM.withQuirks(EnumSet.noneOf(Quirk.class));

  /** Copies what could change. */
  public NetworkSettings {
    quirks = Set.copyOf(quirks);
  }

  /** Whether a quirk is reproduced. */
  public boolean has(Quirk quirk) {
    return quirks.contains(quirk);
  }

  /** Checks what the cameras of one scenario ask for under these settings. */
  public AgentCheck check() {
    return new RoleReader(this, false)::read;
  }

  /** The same settings with these quirks, and no others. */
  public NetworkSettings withQuirks(Set<Quirk> newQuirks) {
    return new NetworkSettings(
        schedule,
        comm,
        bandit,
        graph,
        errorLevel,
        resetLevel,
        banditParameters,
        historicalParameters,
        newQuirks);
  }

  /**
   * The same settings with one schedule and policy for all cameras of the file.
   *
   * @param number of the policy, 0 to 3
   */
  public NetworkSettings withAll(ScheduleKind newSchedule, int number) {
    return new NetworkSettings(
        Optional.of(newSchedule),
        Comm.of(number, Optional.empty()),
        bandit,
        graph,
        errorLevel,
        resetLevel,
        banditParameters,
        historicalParameters,
        quirks);
  }
}
