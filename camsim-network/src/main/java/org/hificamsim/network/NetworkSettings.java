package org.hificamsim.network;

import java.util.EnumSet;
import java.util.Optional;
import java.util.OptionalInt;
import java.util.Set;
import org.hificamsim.network.auction.HistoricalParameters;
import org.hificamsim.network.bandit.BanditParameters;

/**
 * How a scenario's network is run, apart from what the scenario itself says (behaviour 12.1).
 *
 * @param schedule for all cameras of the file, a class name; else what each camera asks for
 * @param comm policy for all cameras of the file, 0 to 4; else what each camera asks for
 * @param customComm class name of the policy where {@code comm} is 4
 * @param bandit for all cameras, a class name; else what each camera asks for
 * @param errorLevel the highest of 100 draws at which a camera fails in a step; -1 for never
 * @param resetLevel the highest of 100 draws at which a failing camera keeps its neighbours
 * @param quirks those that are reproduced
 */
public record NetworkSettings(
    Optional<String> schedule,
    OptionalInt comm,
    Optional<String> customComm,
    Optional<String> bandit,
    GraphUse graph,
    int errorLevel,
    int resetLevel,
    BanditParameters banditParameters,
    HistoricalParameters historicalParameters,
    Set<Quirk> quirks) {
  /** CamSim's own defaults, and all its quirks. */
  public static final NetworkSettings CAMSIM =
      new NetworkSettings(
          Optional.empty(),
          OptionalInt.empty(),
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

  public NetworkSettings {
    quirks = Set.copyOf(quirks);
  }

  public boolean has(Quirk quirk) {
    return quirks.contains(quirk);
  }

  /** The same settings with these quirks, and no others. */
  public NetworkSettings withQuirks(Set<Quirk> newQuirks) {
    return new NetworkSettings(
        schedule,
        comm,
        customComm,
        bandit,
        graph,
        errorLevel,
        resetLevel,
        banditParameters,
        historicalParameters,
        newQuirks);
  }
}
