package org.hificamsim.network;

import java.util.Arrays;
import java.util.List;
import java.util.Optional;
import java.util.stream.Collectors;
import org.hificamsim.core.InputException;
import org.hificamsim.network.agent.CommunicationPolicy;
import org.hificamsim.network.agent.ScheduleKind;

/**
 * What a camera does in CamSim's studies: when it advertises, and whom it asks. As text the
 * capitals of the schedule and the policy's number, {@code A0} for Active and Broadcast.
 *
 * @param comm the policy's number, 0 to 3
 */
public record Strategy(ScheduleKind schedule, int comm) {
  private static final String BETWEEN = "-";
  private static final String EXPECTED =
      "A, P, HA or HP (Active, Passive, HistActive, HistPassive) with 0, 1, 2 or 3 (Broadcast,"
          + " Smooth, Step, Fix), such as A0, or one for each camera with - between";

  /**
   * Strategies as {@code A0-P2-A1}, one for all cameras or one for each, in the file's order.
   *
   * @throws InputException when one is unknown
   */
  public static List<Strategy> list(String text) {
    return Arrays.stream(text.strip().split(BETWEEN, -1))
        .map(one -> find(one).orElseThrow(() -> invalid(text)))
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

  /** Strategies as text. */
  public static String text(List<Strategy> strategies) {
    return strategies.stream().map(Strategy::toString).collect(Collectors.joining(BETWEEN));
  }

  /** In words, such as {@code Active Broadcast}. */
  public String words() {
    return schedule.names().get(0) + " " + CommunicationPolicy.values()[comm].names().get(0);
  }

  @Override
  public String toString() {
    return capitals(schedule) + comm;
  }

  private static String capitals(ScheduleKind schedule) {
    return schedule.names().get(0).replaceAll("[a-z]", "");
  }
}
