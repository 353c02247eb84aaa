package org.hificamsim.network;

import java.util.Arrays;
import java.util.EnumSet;
import java.util.List;
import java.util.Optional;
import java.util.Set;
import org.hificamsim.core.scenario.spec.AgentCheck;
import org.hificamsim.network.agent.HistoricalParameters;
import org.hificamsim.network.agent.ScheduleKind;
import org.hificamsim.network.bandit.BanditAlgorithm;
import org.hificamsim.network.bandit.BanditParameters;

/**
 * How a scenario's network is run, apart from what the scenario itself says (behaviour 12.1).
 *
 * @param strategies of all cameras of the file: one for all, or one for each; where it is empty,
 *     schedule and comm
 * @param schedule for all cameras of the file; else what each camera asks for
 * @param comm policy for all cameras of the file; else what each camera asks for
 * @param bandit for all cameras; else what each camera asks for
 * @param errorLevel the highest of 100 draws at which a camera fails in a step; -1 for never
 * @param resetLevel the highest of 100 draws at which a failing camera keeps its neighbours
 * @param quirks those that are reproduced
 */
public record NetworkSettings(
    List<Strategy> strategies,
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
          List.of(),
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
    strategies = List.copyOf(strategies);
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

  /**
   * What a camera of the file does, if the settings say so.
   *
   * @param camera its place in the file
   */
  Optional<Strategy> strategy(int camera) {
    int place = strategies.size() == 1 ? 0 : camera;
    return strategies.stream().skip(place).findFirst();
  }

  /** The same settings with these quirks, and no others. */
  public NetworkSettings withQuirks(Set<Quirk> newQuirks) {
    return with(strategies, schedule, comm, bandit, banditParameters, newQuirks);
  }

  /** The same settings with these strategies, one for all cameras of the file or one for each. */
  public NetworkSettings withStrategies(List<Strategy> newStrategies) {
    return with(
        newStrategies, Optional.empty(), Optional.empty(), bandit, banditParameters, quirks);
  }

  /** The same settings with a bandit for all cameras, and its weight of utility. */
  public NetworkSettings withBandit(BanditAlgorithm algorithm, double alpha) {
    return with(
        strategies,
        schedule,
        comm,
        Optional.of(algorithm),
        banditParameters.withAlpha(alpha),
        quirks);
  }

  private NetworkSettings with(
      List<Strategy> newStrategies,
      Optional<ScheduleKind> newSchedule,
      Optional<Comm> newComm,
      Optional<BanditAlgorithm> newBandit,
      BanditParameters newParameters,
      Set<Quirk> newQuirks) {
    return new NetworkSettings(
        newStrategies,
        newSchedule,
        newComm,
        newBandit,
        graph,
        errorLevel,
        resetLevel,
        newParameters,
        historicalParameters,
        newQuirks);
  }
}
