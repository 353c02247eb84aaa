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
 * The settings of a network that are not part of its scenario (behaviour 12.1).
 *
 * @param strategies the strategies of the cameras of the file: one for all or one for each; if
 *     empty, schedule and communication count
 * @param schedule the schedule of all cameras of the file; empty for that of each camera
 * @param communication the policy of all cameras of the file; empty for that of each camera
 * @param bandit the bandit of all cameras; empty for that of each camera
 * @param graph how the vision graph of the scenario is used
 * @param errorLevel the highest of the draws 0 to 99 at which a camera fails in a step; -1 for
 *     never
 * @param resetLevel the highest of the draws 0 to 99 at which a failing camera keeps its neighbours
 * @param quirks the quirks that are reproduced
 */
public record NetworkSettings(
    List<Strategy> strategies,
    Optional<ScheduleKind> schedule,
    Optional<CommunicationSetting> communication,
    Optional<BanditAlgorithm> bandit,
    GraphUse graph,
    int errorLevel,
    int resetLevel,
    BanditParameters banditParameters,
    HistoricalParameters historicalParameters,
    Set<Quirk> quirks) {
  /** The use of a scenario's vision graph: CamSim's option {@code -v} (behaviour 3.6). */
  public enum GraphUse {
    AS_IN_FILE(-1),
    STATIC(0),
    IGNORED(1),
    CHANGING(2);

    private final int number;

    GraphUse(int number) {
      this.number = number;
    }

    /** Returns the use with this number of CamSim's. */
    public static Optional<GraphUse> find(int number) {
      return Arrays.stream(values()).filter(use -> use.number == number).findFirst();
    }

    /** Returns whether links are frozen, given whether the file calls its graph static. */
    boolean isStatic(boolean staticInFile) {
      return this == STATIC || (this == AS_IN_FILE && staticInFile);
    }
  }

  /** CamSim's defaults, with all quirks. */
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

  /** CamSim's defaults, without the optional quirks. */
  public static final NetworkSettings DEFAULT = CAMSIM.withQuirks(EnumSet.noneOf(Quirk.class));

  /** Copies the collections. */
  public NetworkSettings {
    strategies = List.copyOf(strategies);
    quirks = Set.copyOf(quirks);
  }

  /** Returns whether a quirk is reproduced. */
  public boolean has(Quirk quirk) {
    return quirks.contains(quirk);
  }

  /** Returns a check of the cameras of one scenario under these settings. */
  public AgentCheck check() {
    return new RoleReader(this, false)::read;
  }

  /**
   * Returns the strategy of a camera of the file.
   *
   * @param camera the index of the camera in the file
   * @return empty if the settings have no strategies, or fewer than cameras
   */
  Optional<Strategy> strategy(int camera) {
    int index = strategies.size() == 1 ? 0 : camera;
    return strategies.stream().skip(index).findFirst();
  }

  /** Returns these settings with other quirks. */
  public NetworkSettings withQuirks(Set<Quirk> newQuirks) {
    return new NetworkSettings(
        strategies,
        schedule,
        communication,
        bandit,
        graph,
        errorLevel,
        resetLevel,
        banditParameters,
        historicalParameters,
        newQuirks);
  }

  /**
   * Returns these settings with other strategies, which replace schedule and communication.
   *
   * @param newStrategies one for all cameras of the file, or one for each
   */
  public NetworkSettings withStrategies(List<Strategy> newStrategies) {
    return new NetworkSettings(
        newStrategies,
        Optional.empty(),
        Optional.empty(),
        bandit,
        graph,
        errorLevel,
        resetLevel,
        banditParameters,
        historicalParameters,
        quirks);
  }

  /**
   * Returns these settings with a bandit for all cameras.
   *
   * @param alpha the weight of utility against communication, 0 to 1
   */
  public NetworkSettings withBandit(BanditAlgorithm algorithm, double alpha) {
    return new NetworkSettings(
        strategies,
        schedule,
        communication,
        Optional.of(algorithm),
        graph,
        errorLevel,
        resetLevel,
        banditParameters.withAlpha(alpha),
        historicalParameters,
        quirks);
  }
}
