package org.hificamsim.network;

import java.util.Optional;
import org.hificamsim.network.agent.CommunicationPolicy;
import org.hificamsim.network.agent.Named;

/**
 * The communication policy set by {@code comm} and {@code customcom} of a camera, or by {@code -c}
 * and {@code -u} for all cameras (behaviour 3.2, 3.6).
 *
 * @param number 0 to 3 for CamSim's policies, {@link #CUSTOM} for a policy named by its class
 * @param freezesLinks whether links keep their strength
 */
public record CommunicationSetting(int number, CommunicationPolicy policy, boolean freezesLinks) {
  /** The number of a policy named by its class. */
  public static final int CUSTOM = 4;

  private static final String OLD_FIX = "epics.commpolicy.Fix";

  /**
   * Returns the setting with a number and a class name.
   *
   * @param number 0 to 4
   * @param className the class of the policy; read only if the number is {@link #CUSTOM}
   * @return empty if the class name is missing or unknown
   */
  public static Optional<CommunicationSetting> of(int number, Optional<String> className) {
    if (number == CUSTOM) {
      return className
          .flatMap(name -> Named.find(CommunicationPolicy.class, name))
          .map(policy -> new CommunicationSetting(number, policy, className.get().equals(OLD_FIX)));
    }
    CommunicationPolicy policy = CommunicationPolicy.values()[number];
    return Optional.of(new CommunicationSetting(number, policy, policy == CommunicationPolicy.FIX));
  }

  /** Returns whether the policy is Fix and was chosen by its number. */
  boolean isFix() {
    return number != CUSTOM && policy == CommunicationPolicy.FIX;
  }
}
