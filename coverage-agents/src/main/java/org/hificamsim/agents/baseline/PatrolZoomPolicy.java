package org.hificamsim.agents.baseline;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.agents.choice.AbstractDistributedZoomPolicy;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/** Each camera patrols over its pan angles back and forth, at one zoom level, whatever it sees. */
public final class PatrolZoomPolicy extends AbstractDistributedZoomPolicy {
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

  /** A camera's way over its pan angles, back and forth. */
  static final class Round {
    private final int dwell;
    private int left;
    private int direction = 1;

    /**
     * @param dwell steps that the camera stays in each view, 1 or more
     */
    Round(int dwell) {
      this.dwell = dwell;
      left = dwell;
    }

    /** The camera's next view; first of all one with the zoom level that was asked for. */
    int next(NetworkView network, int camera, int zoom) {
      int view = network.view(camera);
      int pan = network.panOf(camera, view);
      boolean zoomed = view != network.viewAt(camera, pan, zoom);
      if (!zoomed && left > 0) {
        left--;
        return view;
      }
      left = dwell - 1;
      int next = zoomed ? pan : turn(pan, network.pans(camera));
      return network.viewAt(camera, next, zoom);
    }

    private int turn(int pan, int pans) {
      if (pans == 1) {
        return pan;
      }
      boolean atEnd = pan + direction < 0 || pan + direction >= pans;
      direction = atEnd ? -direction : direction;
      return pan + direction;
    }
  }

  private final int dwell;
  private final Zoom zoom;
  private Round[] rounds = {};

  /** Reads the options {@code dwell} and {@code zoom}. */
  public PatrolZoomPolicy(Options options) {
    dwell =
        options.integer("dwell", 1, 1, MAX_DWELL, "steps that a camera stays at each pan angle");
    zoom = options.choice("zoom", Zoom.WIDEST, "the zoom level: widest, middle, narrowest");
  }

  @Override
  public String name() {
    return "patrol";
  }

  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    rounds = new Round[network.cameras()];
    Arrays.setAll(rounds, camera -> new Round(dwell));
  }

  @Override
  protected int choose(NetworkView network, int camera) {
    return rounds[camera].next(network, camera, zoom.of(network.zooms(camera)));
  }
}
