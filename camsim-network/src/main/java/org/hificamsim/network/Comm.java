package org.hificamsim.network;

import java.util.Optional;
import org.hificamsim.network.agent.CommunicationPolicy;
import org.hificamsim.network.agent.Named;

/**
 * What {@code comm} and {@code customcom} of a camera say, or {@code -c} and {@code -u} of all
 * (behaviour 3.2, 3.6).
 *
 * @param number 0 to 3 for one of CamSim's policies, {@link #CUSTOM} for one named by its class
 * @param freezesLinks whether links neither fade nor grow
 */
public record Comm(int number, CommunicationPolicy policy, boolean freezesLinks) {
  /** The number of a policy named by its class. */
  public static final int CUSTOM = 4;

  private static final String OLD_FIX = "epics.commpolicy.Fix";

  /**
   * The policy asked for.
   *
   * @param number 0 to 4
   * @param className of the policy where the number is {@link #CUSTOM}
   * @return empty where the class name is missing or not known
   */
  public static Optional<Comm> of(int number, Optional<String> className) {
    if (number == CUSTOM) {
      return className
          .flatMap(name -> Named.find(CommunicationPolicy.class, name))
          .map(policy -> new Comm(number, policy, className.get().equals(OLD_FIX)));
    }
    CommunicationPolicy policy = CommunicationPolicy.values()[number];
    return Optional.of(new Comm(number, policy, policy == CommunicationPolicy.FIX));
  }

  /** Whether Fix is asked for by its number. */
  boolean isFix() {
    return number != CUSTOM && policy == CommunicationPolicy.FIX;
  }
}
