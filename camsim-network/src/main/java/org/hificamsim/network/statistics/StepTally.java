package org.hificamsim.network.statistics;

import org.hificamsim.core.world.Targets;
import org.hificamsim.core.world.World;
import org.hificamsim.network.agent.Agent;
import org.hificamsim.network.agent.MessageQueue;

/** Adds a step's figures up, camera by camera (behaviour 7, steps 8 to 11). */
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

  /** Sums of a world's steps, at 0. */
  public StepTally(World world, CameraFigures figures, MessageQueue queue) {
    this.targets = world.targets();
    this.overlaps =
        new OverlapTable(world.cameras(), new CamSimOverlap(world.scenario().field())::of);
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
   * Counts an online camera that has settled its auctions and been measured.
   *
   * @param earned utility and prices of a camera whose bandit learns from them, else 0
   * @param sent what the camera attempted to send
   */
  public void settled(Agent agent, double earned, int sent) {
    attempts += sent;
    banditUtility += earned;
    overlap = overlaps.addPairs(agent.camera(), overlap);
    confidence += figures.relativeConfidence();
    tracked += figures.tracked();
  }

  /** Counts an online camera's utility, once all have settled. */
  public void count(Agent agent) {
    utility += figures.utility(agent);
  }

  /** The row of the step. */
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

  /** Of the targets present; 0 without any, also where one that is gone counts as tracked (Q6). */
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
