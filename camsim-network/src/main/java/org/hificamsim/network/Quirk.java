package org.hificamsim.network;

import java.util.Arrays;
import java.util.Optional;
import org.hificamsim.core.Spelling;

/**
 * Peculiarities of CamSim that can be reproduced or left out (behaviour 11). Its other quirks are
 * either always kept, because its numbers depend on them, or always fixed.
 */
public enum Quirk {
  /** Targets whose class name selects waypoints use their heading as their speed. */
  WAYPOINT_SPEED_IS_HEADING("Q3"),
  /**
   * The policy freezes links, and the previous camera's policy reverses them, instead of the graph.
   */
  LINKS_FREEZE_BY_POLICY("Q5"),
  /** A camera that an event switches off for some steps never comes back. */
  FAILED_CAMERAS_STAY_OFFLINE("Q6"),
  /** Prices are not second prices, and prices paid within a step are not added up. */
  MISPRICED_SALES("Q14"),
  /** The movement that an event names by {@code move} is ignored. */
  EVENT_MOVE_IGNORED("Q17"),
  /** The order of bids, and so the winner of a tie, depends on hash codes. */
  TIES_BY_HASH_CODE("Q19");

  private final String number;

  Quirk(String number) {
    this.number = number;
  }

  /** Finds a quirk by its name, such as {@code ties-by-hash-code}, or its number, such as Q19. */
  public static Optional<Quirk> find(String text) {
    return Arrays.stream(values())
        .filter(quirk -> Spelling.of(quirk).equals(text) || quirk.number.equalsIgnoreCase(text))
        .findFirst();
  }
}
