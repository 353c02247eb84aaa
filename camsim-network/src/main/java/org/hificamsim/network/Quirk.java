package org.hificamsim.network;

import java.util.Arrays;
import java.util.Optional;
import org.hificamsim.core.Spelling;

/**
 * Peculiarities of CamSim that are reproduced or not, as asked (behaviour 11). The others are
 * either always kept, because its numbers depend on them, or always fixed.
 */
public enum Quirk {
  /** Targets whose waypoints come through a class name take their heading for their speed. */
  WAYPOINT_SPEED_IS_HEADING("Q3"),
  /** Links are frozen, and known both ways, by a policy (or the one before), not by the graph. */
  LINKS_FREEZE_BY_POLICY("Q5"),
  /** A camera that an event switched off for some steps never comes back. */
  FAILED_CAMERAS_STAY_OFFLINE("Q6"),
  /** Prices are not second prices, and what is paid within a step does not add up. */
  MISPRICED_SALES("Q14"),
  /** The movement that an event names by {@code move} is ignored. */
  EVENT_MOVE_IGNORED("Q17"),
  /** The order of bids, and so who wins a tie, depends on hash codes. */
  TIES_BY_HASH_CODE("Q19");

  private final String number;

  Quirk(String number) {
    this.number = number;
  }

  /** The quirk of this name, such as {@code ties-by-hash-code}, or number in the behaviour file. */
  public static Optional<Quirk> find(String text) {
    return Arrays.stream(values())
        .filter(quirk -> Spelling.of(quirk).equals(text) || quirk.number.equalsIgnoreCase(text))
        .findFirst();
  }
}
