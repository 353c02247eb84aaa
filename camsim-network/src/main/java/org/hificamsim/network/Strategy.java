package org.hificamsim.network;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;
import org.hificamsim.network.agent.CommunicationPolicy;
import org.hificamsim.network.agent.ScheduleKind;

/**
 * The strategy of a camera in CamSim's studies: when it advertises, and which cameras it asks. Its
 * text has the capitals of the schedule and the number of the policy, such as {@code A0} for Active
 * and Broadcast.
 *
 * @param policyNumber the number of the communication policy, 0 to 3
 */
public record Strategy(ScheduleKind schedule, int policyNumber) {
  private static final String SEPARATOR = "-";
  private static final String EXPECTED =
      "A, P, HA or HP (Active, Passive, HistActive, HistPassive) with 0, 1, 2 or 3 (Broadcast,"
          + " Smooth, Step, Fix), such as A0, or one for each camera with - between";

  /**
   * Parses strategies such as {@code A0-P2-A1}: one for all cameras, or one for each in the order
   * of the file.
   *
   * @throws InputException if a strategy is unknown
   */
  public static List<Strategy> parse(String text) {
    return Arrays.stream(text.strip().split(SEPARATOR, -1))
        .map(strategy -> find(strategy).orElseThrow(() -> invalid(text)))
        .toList();
  }

  private static InputException invalid(String text) {
    return new InputException("strategies are '" + text + "', expected " + EXPECTED);
  }

  private static Optional<Strategy> find(String text) {
    return Arrays.stream(ScheduleKind.values())
        .filter(schedule -> schedule != ScheduleKind.BANDIT_ZOOM)
        .filter(schedule -> text.matches(capitals(schedule) + "[0-3]"))
        .map(schedule -> new Strategy(schedule, text.charAt(text.length() - 1) - '0'))
        .findFirst();
  }

  /** Returns the text that {@link #parse} reads. */
  public static String text(List<Strategy> strategies) {
    return strategies.stream().map(Strategy::toString).collect(Collectors.joining(SEPARATOR));
  }

  /** Returns the names of schedule and policy, such as {@code Active Broadcast}. */
  public String words() {
    return schedule.names().get(0)
        + " "
        + CommunicationPolicy.values()[policyNumber].names().get(0);
  }

  @Override
  public String toString() {
    return capitals(schedule) + policyNumber;
  }

  private static String capitals(ScheduleKind schedule) {
    return schedule.names().get(0).replaceAll("[a-z]", "");
  }
}
