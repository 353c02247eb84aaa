package org.hificamsim.network.agent;

import java.util.Arrays;
import org.hificamsim.core.world.Targets;

/**
 * Decides when a camera advertises an owned target, and how much a target is worth to it (behaviour
 * 8.3, 8.7). An active camera advertises each target in every step. A passive one advertises a
 * target that is out of sight, or faint and becoming fainter. Historical schedules weigh the
 * confidence by how long similar targets have stayed in view.
 */
public final class AuctionSchedule {
  private static final double FAINT = 0.1;

  private final double[] lastConfidences;
  private final ViewHistory history;
  private ScheduleKind kind;

  /** Creates the schedule of a camera at the start of a run. */
  public AuctionSchedule(ScheduleKind kind, Targets targets, HistoricalParameters parameters) {
    this.kind = kind;
    lastConfidences = new double[targets.count()];
    history = kind.isHistorical() ? new ViewHistory(targets, parameters) : null;
  }

  ScheduleKind kind() {
    return kind;
  }

  /** The direction of a target, from 1, or 0 while unknown; only for historical schedules. */
  public int category(int target) {
    return history.category(target);
  }

  boolean advertises(int target, double confidence) {
    return kind.isActive() || isFading(target, confidence);
  }

  private boolean isFading(int target, double confidence) {
    double lastConfidence = lastConfidences[target];
    lastConfidences[target] = confidence;
    return confidence < FAINT && (confidence == 0 || confidence < lastConfidence);
  }

  double value(int target, double confidence) {
    return kind.isHistorical() ? history.value(target, confidence) : confidence;
  }

  /**
   * Switches to a schedule without history. Only passive schedules keep confidences to compare
   * with.
   */
  void switchTo(ScheduleKind plain) {
    if (kind.isActive() && !plain.isActive()) {
      Arrays.fill(lastConfidences, 0);
    }
    kind = plain;
  }

  void endStep() {
    if (kind.isHistorical()) {
      history.endStep();
    }
  }
}
