package org.hificamsim.core.engine;

import org.hificamsim.core.detection.DetectionModel;
import org.hificamsim.core.silhouette.HiddenShares;
import org.hificamsim.core.world.SightLines;
import org.hificamsim.core.world.World;

/**
 * Computes how far targets are hidden from cameras: by blocked lines of sight, or by degrees if the
 * detection model depends on hidden shares.
 */
final class Obstruction {
  private final SightLines lines;

  /** The hidden shares; null unless the detection model depends on them. */
  private final HiddenShares shares;

  private final boolean open;

  Obstruction(World world, DetectionModel model) {
    lines = world.sightLines();
    shares = model.dependsOnHiddenShare() ? new HiddenShares(world) : null;
    open = shares == null && lines.open();
  }

  /** Forgets shares, since targets or cameras may have moved. */
  void begin() {
    if (shares != null) {
      shares.begin();
    }
  }

  /** Whether nothing hides targets. */
  boolean open() {
    return open;
  }

  /** Whether targets are hidden by degrees. */
  boolean byShares() {
    return shares != null;
  }

  /**
   * The part of a target's light that reaches a camera, in [0, 1]. If the model depends on hidden
   * shares, solid things count only by {@link #hiddenShare}, unless they hide the whole target.
   */
  double transmittance(int camera, int target) {
    if (shares == null) {
      return open ? 1 : lines.transmittance(camera, target);
    }
    return shares.share(camera, target) < 1 ? lines.throughGlass(camera, target) : 0;
  }

  /** The share of a target that is hidden, 0 unless the detection model depends on it. */
  double hiddenShare(int camera, int target) {
    return shares == null ? 0 : shares.share(camera, target);
  }
}
