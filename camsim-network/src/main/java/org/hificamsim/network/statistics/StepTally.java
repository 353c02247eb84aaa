package org.hificamsim.network.statistics;

import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;
import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.MessageQueue;

/** Adds up the figures of a step, camera by camera (behaviour 7, steps 8 to 11). */
public final class StepTally {
  private final Targets targets;
  private final OverlapTable overlaps;
  private final CameraFigures figures;
  private final MessageQueue queue;
  private double utility;
  private double banditUtility;
  private long attempts;
  private int strategyChanges;
  private double overlap;
  private double confidence;
  private int tracked;

  /** Creates the tally of a world, with all sums at 0. */
  public StepTally(World world, CameraFigures figures, MessageQueue queue) {
    this.targets = world.targets();
    this.overlaps =
        new OverlapTable(world.cameras(), new CamSimOverlap(world.scenario().field())::overlap);
    this.figures = figures;
    this.queue = queue;
  }

  /** Starts a step. */
  public void begin() {
    queue.resetCounts();
    utility = 0.0;
    banditUtility = 0.0;
    attempts = 0;
    strategyChanges = 0;
    overlap = 0.0;
    confidence = 0.0;
    tracked = 0;
  }

  /** Counts a camera that changed its schedule or policy. */
  public void strategyChanged() {
    strategyChanges++;
  }

  /**
   * Adds the figures of an online camera that has settled its auctions and been measured.
   *
   * @param earned utility and prices of a camera whose bandit learns from them, else 0
   * @param attemptsOfCamera the number of StartSearch messages that the camera attempted
   */
  public void addCamera(Agent agent, double earned, int attemptsOfCamera) {
    attempts += attemptsOfCamera;
    banditUtility += earned;
    overlap = overlaps.addPairs(agent.camera(), overlap);
    confidence += figures.relativeConfidence();
    tracked += figures.tracked();
  }

  /** Adds the utility of an online camera, after all cameras have settled their auctions. */
  public void addUtility(Agent agent) {
    utility += figures.utility(agent);
  }

  /** Returns the row of the step. */
  public StepFigures end(long step) {
    return new StepFigures(
        step,
        utility,
        queue.startSearches(),
        strategyChanges,
        banditUtility,
        attempts,
        overlap,
        confidence,
        proportion(),
        queue.startTrackings());
  }

  /** The proportion of the present targets that are tracked; 0 if none is present (quirk Q6). */
  private double proportion() {
    int present = present();
    return present == 0 ? 0 : (double) tracked / present;
  }

  private int present() {
    int present = 0;
    for (int target = 0; target < targets.count(); target++) {
      if (targets.present(target)) {
        present++;
      }
    }
    return present;
  }
}
