package org.hificamsim.reproduction;

import static org.hificamsim.reproduction.ReproductionPlans.CAMSIM;
import static org.hificamsim.reproduction.ReproductionPlans.HIFI;

import com.fasterxml.jackson.databind.ObjectMapper;
import java.util.List;
import org.hificamsim.core.file.Io;

/**
 * A cell of Table 8.1 ("Improving the Fidelity of Abstract Camera Network Simulations", PhD thesis,
 * Aston University, December 2019), from the resource {@code published.json}.
 *
 * @param hifi whether the detection model is the high-fidelity one, not CamSim's
 * @param proportion share of the greedy approach's performance
 */
public record PublishedCell(Layout layout, String policy, boolean hifi, double proportion) {
  /**
   * Thesis 7.4.4: the share of the greedy performance that epsilon-greedy reaches in scenario 4.
   */
  public static final double EPSILON_GREEDY_IN_4 = 0.81;

  /** Thesis 7.4.4: the share that SARSA reaches in scenario 4. */
  public static final double SARSA_IN_4 = 0.87;

  /** The policies of the table, in its order. */
  public static final List<String> POLICIES = List.of("zoom-out", "epsilon-greedy", "sarsa");

  /** The name of the detection model. */
  public String detection() {
    return hifi ? HIFI : CAMSIM;
  }

  /** All eighteen cells. */
  public static List<PublishedCell> table() {
    return Io.get(
        () ->
            List.of(
                new ObjectMapper()
                    .readValue(
                        Io.resource(PublishedCell.class, "published.json"),
                        PublishedCell[].class)));
  }
}
