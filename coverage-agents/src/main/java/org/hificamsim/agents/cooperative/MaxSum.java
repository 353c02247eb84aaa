package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.NetworkView;

/**
 * Max-sum (Farinelli, Rogers, Petcu and Jennings, 2008) on a graph of cameras and of the targets
 * that they may detect, each target once for each step of the forecast.
 *
 * <p>A camera sends, for each target and step, what it would lose elsewhere by detecting it. From
 * these messages, every camera computes the worth of its own detection if all others choose what is
 * best for all. Because this worth depends only on the number of cameras that detect a target, the
 * best others are those that lose least (Tarlow, Givoni and Zemel, 2010). The graph has cycles, so
 * there is no guarantee; messages are damped.
 *
 * <p>For the other cameras, a view counts as detecting a target if its chance is 0.5 or more.
 */
final class MaxSum implements Agreement {
  private static final double DAMPING = 0.5;
  private static final double DETECTING = 0.5;

  /** The greatest loss, in place of infinity. */
  private static final double MAX_LOSS = 1e6;

  /** The message of a camera that does not take part, or cannot detect the target. */
  private static final double NO_MESSAGE = -MAX_LOSS;

  private final int rounds;

  /**
   * The last messages, by camera and by number of target and step: the best total without the
   * detection subtracted from the best total with it, which is the camera's loss with its sign
   * changed. Before reading a message, a receiver checks whether the sender's last one arrived.
   */
  private final double[][] messages;

  private final double[] sortedLosses;
  private double[] viewTotals = {};
  private double[] rowWorths = {};

  MaxSum(Parameters parameters, NetworkView network) {
    if (!parameters.identified()) {
      throw new InputException(
          "agree is 'max-sum' with identity 'none', expected identity=known: cameras send messages"
              + " about targets");
    }
    rounds = parameters.rounds();
    messages = new double[network.cameras()][network.targets() * parameters.horizon()];
    sortedLosses = new double[network.cameras()];
  }

  @Override
  public void agree(NetworkView network, Team team) {
    for (double[] cameraMessages : messages) {
      Arrays.fill(cameraMessages, NO_MESSAGE);
    }
    for (int round = 0; round < rounds; round++) {
      for (int camera = 0; camera < messages.length; camera++) {
        if (network.online(camera)) {
          evaluateViews(network, team, camera);
          sendMessages(network, team, camera);
        }
      }
    }
    for (int camera = 0; camera < messages.length; camera++) {
      if (network.online(camera)) {
        evaluateViews(network, team, camera);
        team.choose(network, camera, team.plan(camera).best(network, camera, viewTotals));
      }
    }
  }

  /** Computes what each view of a camera is worth, given the messages that it received. */
  private void evaluateViews(NetworkView network, Team team, int camera) {
    Plan plan = team.plan(camera);
    ViewForecast viewForecast = plan.viewForecast(camera);
    int views = network.views(camera);
    int rows = viewForecast.rows();
    viewTotals = viewTotals.length < views ? new double[views] : viewTotals;
    rowWorths = rowWorths.length < rows ? new double[2 * rows] : rowWorths;
    plan.gainsBeyondTracks(network, camera, viewTotals);
    for (int row = 0; row < rows; row++) {
      rowWorths[row] = worthOfDetection(team, plan, camera, viewForecast.slot(row));
      for (int view = 0; view < views; view++) {
        viewTotals[view] += viewForecast.chance(row, view) * rowWorths[row];
      }
    }
  }

  /** The worth of a camera's detection of the target of a slot in its step. */
  private double worthOfDetection(Team team, Plan plan, int camera, int slot) {
    int others = 0;
    for (int sender = 0; sender < messages.length; sender++) {
      double message = messages[sender][plan.targetAndStep(slot)];
      if (sender != camera && message > NO_MESSAGE && team.bidHasArrived(sender, camera)) {
        sortedLosses[others++] = -message;
      }
    }
    Arrays.sort(sortedLosses, 0, others);
    double sum = 0;
    double bestWithout = 0;
    double bestWith = plan.worth(slot, 1);
    for (int k = 1; k <= others; k++) {
      sum -= sortedLosses[k - 1];
      bestWithout = Math.max(bestWithout, sum + plan.worth(slot, k));
      bestWith = Math.max(bestWith, sum + plan.worth(slot, k + 1));
    }
    return bestWith - bestWithout;
  }

  private void sendMessages(NetworkView network, Team team, int camera) {
    Plan plan = team.plan(camera);
    ViewForecast viewForecast = plan.viewForecast(camera);
    for (int row = 0; row < viewForecast.rows(); row++) {
      double bestWith = -MAX_LOSS;
      double bestWithout = -MAX_LOSS;
      for (int view = 0; view < network.views(camera); view++) {
        double chance = viewForecast.chance(row, view);
        double totalElsewhere = viewTotals[view] - chance * rowWorths[row];
        if (chance >= DETECTING) {
          bestWith = Math.max(bestWith, totalElsewhere);
        } else {
          bestWithout = Math.max(bestWithout, totalElsewhere);
        }
      }
      double message = Math.max(NO_MESSAGE, Math.min(MAX_LOSS, bestWith - bestWithout));
      int index = plan.targetAndStep(viewForecast.slot(row));
      messages[camera][index] = damped(messages[camera][index], message);
    }
    team.bid(camera, viewForecast.rows());
  }

  private static double damped(double before, double now) {
    boolean first = before == NO_MESSAGE || now == NO_MESSAGE;
    return first ? now : DAMPING * before + (1 - DAMPING) * now;
  }
}
