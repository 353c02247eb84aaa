package org.hificamsim.agents.cooperative;

import java.util.Arrays;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.NetworkView;

/**
 * Max-sum (Farinelli, Rogers, Petcu and Jennings, 2008) over a graph of cameras and of the targets
 * that they may detect, each in each step of the forecast. A camera tells of each of these what it
 * would lose elsewhere by detecting it; each works out from that what detecting it is worth if all
 * others do what is best for all. The worth depends on how many detect a target alone, so the best
 * others are those that lose least (Tarlow, Givoni and Zemel, 2010). The graph has cycles, so
 * nothing is guaranteed; messages are damped.
 *
 * <p>A view counts as detecting a target for others where its chance is a half or more.
 */
final class MaxSum implements Agreement {
  private static final double DAMPING = 0.5;
  private static final double MUCH = 1e6; // in place of infinity
  private static final double ABSENT = -MUCH;

  private final int rounds;
  private final double[][] losses; // by camera, target and step: what others gain it by, negative
  private final double[] sorted; // room for those of one slot, the least loss first
  private double[] totals = {}; // by view of one camera
  private double[] worths = {}; // by row of one camera

  MaxSum(Parameters parameters, NetworkView network) {
    if (!parameters.named()) {
      throw new InputException(
          "agree is 'max-sum' with identity 'none', expected identity=known: cameras speak of"
              + " targets");
    }
    rounds = parameters.rounds();
    losses = new double[network.cameras()][network.targets() * parameters.horizon()];
    sorted = new double[network.cameras()];
  }

  @Override
  public void agree(NetworkView network, Team team) {
    for (double[] of : losses) {
      Arrays.fill(of, ABSENT);
    }
    for (int round = 0; round < rounds; round++) {
      for (int camera = 0; camera < losses.length; camera++) {
        if (network.online(camera)) {
          weigh(network, team, camera);
          tell(network, team, camera);
        }
      }
    }
    for (int camera = 0; camera < losses.length; camera++) {
      if (network.online(camera)) {
        weigh(network, team, camera);
        team.choose(network, camera, team.plan(camera).best(network, camera, totals));
      }
    }
  }

  /** Finds what each view of a camera is worth, from what it received. */
  private void weigh(NetworkView network, Team team, int camera) {
    Plan plan = team.plan(camera);
    ViewForecast outlook = plan.outlook(camera);
    int views = network.views(camera);
    totals = totals.length < views ? new double[views] : totals;
    worths = worths.length < outlook.rows() ? new double[2 * outlook.rows()] : worths;
    plan.search(network, camera, totals);
    for (int row = 0; row < outlook.rows(); row++) {
      worths[row] = worth(team, plan, camera, outlook.slot(row));
      for (int view = 0; view < views; view++) {
        totals[view] += outlook.chance(row, view) * worths[row];
      }
    }
  }

  /** What it is worth that a camera detects a target in a step. */
  private double worth(Team team, Plan plan, int camera, int slot) {
    int others = 0;
    for (int other = 0; other < losses.length; other++) {
      double loss = losses[other][plan.key(slot)];
      if (other != camera && loss > ABSENT && team.hears(camera, other)) {
        sorted[others++] = -loss;
      }
    }
    Arrays.sort(sorted, 0, others);
    double sum = 0;
    double without = 0;
    double with = plan.worth(slot, 1);
    for (int k = 1; k <= others; k++) {
      sum -= sorted[k - 1];
      without = Math.max(without, sum + plan.worth(slot, k));
      with = Math.max(with, sum + plan.worth(slot, k + 1));
    }
    return with - without;
  }

  /** A camera tells what it would lose by each target and step. */
  private void tell(NetworkView network, Team team, int camera) {
    Plan plan = team.plan(camera);
    ViewForecast outlook = plan.outlook(camera);
    for (int row = 0; row < outlook.rows(); row++) {
      double on = -MUCH;
      double off = -MUCH;
      for (int view = 0; view < network.views(camera); view++) {
        double chance = outlook.chance(row, view);
        double rest = totals[view] - chance * worths[row];
        on = chance >= 0.5 ? Math.max(on, rest) : on;
        off = chance >= 0.5 ? off : Math.max(off, rest);
      }
      int key = plan.key(outlook.slot(row));
      double before = losses[camera][key];
      double now = Math.max(ABSENT, Math.min(MUCH, on - off));
      boolean fresh = before == ABSENT || now == ABSENT;
      losses[camera][key] = fresh ? now : DAMPING * before + (1 - DAMPING) * now;
    }
    team.bid(network, camera, outlook.rows());
  }
}
