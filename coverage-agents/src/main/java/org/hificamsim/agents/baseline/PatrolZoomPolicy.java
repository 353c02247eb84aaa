package org.hificamsim.agents.baseline;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.agents.choice.AbstractDistributedZoomPolicy;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/** Each camera patrols over its pan angles back and forth, at one zoom level, whatever it sees. */
public final class PatrolZoomPolicy extends AbstractDistributedZoomPolicy {
  public static final String NAME = "patrol";

  static final int MAX_DWELL = 1_000_000;

  /** Which of its zoom levels a camera patrols with. */
  public enum Zoom {
    WIDEST,
    MIDDLE,
    NARROWEST;

    int of(int zooms) {
      return switch (this) {
        case WIDEST -> zooms - 1;
        case MIDDLE -> zooms / 2;
        case NARROWEST -> 0;
      };
    }
  }

  private final int dwell;
  private final Zoom zoom;
  private PanPatrol[] patrols = {};

  /** Reads the options {@code dwell} and {@code zoom}. */
  public PatrolZoomPolicy(Options options) {
    dwell =
        options.integer("dwell", 1, 1, MAX_DWELL, "steps that a camera stays at each pan angle");
    zoom = options.choice("zoom", Zoom.WIDEST, "the zoom level: widest, middle, narrowest");
  }

  @Override
  public String name() {
    return NAME;
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    patrols = new PanPatrol[network.cameras()];
    Arrays.setAll(patrols, camera -> new PanPatrol(dwell));
  }

  @Override
  protected int choose(NetworkView network, int camera) {
    return patrols[camera].next(network, camera, zoom.of(network.zooms(camera)));
  }
}
