package org.hificamsim.network.agent;

import java.util.Arrays;
import org.hificamsim.core.world.Targets;

/**
 * When one camera advertises what it owns, and what a target is worth to it (behaviour 8.3, 8.7).
 * An active camera advertises each target in every step, a passive one a target that is out of
 * sight, or faint and getting fainter. Historical schedules weigh the confidence with how long such
 * targets used to stay in view.
 */
public final class AuctionSchedule {
  private static final double FAINT = 0.1;

  private final double[] last;
  private final ViewHistory history;
  private ScheduleKind kind;

  /** The schedule at the start of a run. */
  public AuctionSchedule(ScheduleKind kind, Targets targets, HistoricalParameters parameters) {
    this.kind = kind;
    last = new double[targets.count()];
    history = kind.isHistorical() ? new ViewHistory(targets, parameters) : null;
  }

  ScheduleKind kind() {
    return kind;
  }

  /** A target's direction, from 1; 0 while it is not known; for what began as historical alone. */
  public int category(int target) {
    return history.category(target);
  }

  boolean advertises(int target, double confidence) {
    return kind.isActive() || isFading(target, confidence);
  }

  private boolean isFading(int target, double confidence) {
    double before = last[target];
    last[target] = confidence;
    return confidence < FAINT && (confidence == 0 || confidence < before);
  }

  double value(int target, double confidence) {
    return kind.isHistorical() ? history.value(target, confidence) : confidence;
  }

  /** Becomes a plain schedule; one that was active has no confidences to compare with. */
  void switchTo(ScheduleKind plain) {
    if (kind.isActive() && !plain.isActive()) {
      Arrays.fill(last, 0);
    }
    kind = plain;
  }

  void settled() {
    if (kind.isHistorical()) {
      history.endStep();
    }
  }
}
