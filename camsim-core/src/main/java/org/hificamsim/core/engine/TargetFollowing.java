package org.hificamsim.core.engine;

import java.util.Arrays;
import org.hificamsim.core.metrics.StepCoverage;
import org.hificamsim.core.policy.OracleView;

/**
 * Measures when targets are found, lost, found again and handed over ({@code docs/following.md}).
 *
 * <p>A target that vanishes while it is lost is not found again; one that comes back has to be
 * found as if it were new.
 */
public final class TargetFollowing implements StepListener {
  /** The history of one target since it appeared. */
  private static final class Life {
    private long present;
    private long longestCover;

    /** The length of the present cover, gap or wait, steps. */
    private long stretch;

    private boolean found;
    private int holder = Holders.NONE;
  }

  private final Holders holders = new Holders();
  private Life[] lives = {};
  private double finds;
  private double stepsToFind;
  private double losses;
  private double endedLosses;
  private double stepsLost;
  private double handovers;

  @Override
  public void stepped(OracleView network, StepCoverage coverage) {
    if (lives.length < network.targets()) {
      int known = lives.length;
      lives = Arrays.copyOf(lives, network.targets());
      Arrays.setAll(lives, target -> target < known ? lives[target] : new Life());
    }
    holders.update(network);
    for (int target = 0; target < lives.length; target++) {
      if (network.present(target)) {
        measure(lives[target], holders.holder(target));
      } else {
        end(lives[target]);
      }
    }
  }

  private void measure(Life life, int holder) {
    life.present++;
    if (holder == Holders.NONE) {
      lose(life);
    } else {
      keep(life, holder);
    }
    life.holder = holder;
    life.stretch++;
  }

  private void lose(Life life) {
    if (life.holder != Holders.NONE) {
      losses++;
      life.stretch = 0;
    }
  }

  private void keep(Life life, int holder) {
    if (life.holder == Holders.NONE) {
      find(life);
    } else if (life.holder != holder) {
      handovers++;
    }
    life.longestCover = Math.max(life.longestCover, life.stretch + 1);
  }

  private void find(Life life) {
    if (life.found) {
      endedLosses++;
      stepsLost += life.stretch;
    } else {
      finds++;
      stepsToFind += life.stretch;
    }
    life.found = true;
    life.stretch = 0;
  }

  private static void end(Life life) {
    life.stretch = 0;
    life.found = false;
    life.holder = Holders.NONE;
  }

  /** The sums over all steps so far. */
  public FollowingSums sums() {
    return new FollowingSums(
        mean(stepsToFind, finds),
        mean(stepsLost, endedLosses),
        losses,
        endedLosses,
        unbroken(),
        handovers);
  }

  private double unbroken() {
    double sum = 0;
    int targets = 0;
    for (Life life : lives) {
      if (life.present > 0) {
        sum += (double) life.longestCover / life.present;
        targets++;
      }
    }
    return mean(sum, targets);
  }

  private static double mean(double sum, double count) {
    return count == 0 ? Double.NaN : sum / count;
  }
}
