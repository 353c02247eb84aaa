package org.hificamsim.agents.baseline;

import java.util.Arrays;
import java.util.SplittableRandom;
import org.hificamsim.agents.choice.AbstractDistributedZoomPolicy;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.registry.Options;

/**
 * Each camera sweeps its pan angles back and forth at one zoom level, regardless of what it sees.
 */
public final class PatrolZoomPolicy extends AbstractDistributedZoomPolicy {
  static final int MAX_DWELL = 1_000_000;

  /** The zoom level at which a camera patrols. */
  public enum Zoom {
    WIDEST,
    MIDDLE,
    NARROWEST;

    /** The number of this level, for a camera with so many levels. */
    int number(int zooms) {
      return switch (this) {
        case WIDEST -> zooms - 1;
        case MIDDLE -> zooms / 2;
        case NARROWEST -> 0;
      };
    }
  }

  /** The movement of a camera over its pan angles, back and forth. */
  static final class Sweep {
    private final int dwell;
    private int stepsLeft;
    private int direction = 1;

    /**
     * @param dwell number of steps that the camera stays in each view, 1 or more
     */
    Sweep(int dwell) {
      this.dwell = dwell;
      stepsLeft = dwell;
    }

    /** Returns the camera's next view; it changes its zoom level before it turns. */
    int next(NetworkView network, int camera, int zoom) {
      int view = network.view(camera);
      int pan = network.panOf(camera, view);
      boolean atZoom = view == network.viewAt(camera, pan, zoom);
      if (atZoom && stepsLeft > 0) {
        stepsLeft--;
        return view;
      }
      stepsLeft = dwell - 1;
      int nextPan = atZoom ? nextPan(pan, network.pans(camera)) : pan;
      return network.viewAt(camera, nextPan, zoom);
    }

    private int nextPan(int pan, int pans) {
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
  private Sweep[] sweeps = {};

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
    sweeps = new Sweep[network.cameras()];
    Arrays.setAll(sweeps, camera -> new Sweep(dwell));
  }

  @Override
  protected int choose(NetworkView network, int camera) {
    return sweeps[camera].next(network, camera, zoom.number(network.zooms(camera)));
  }
}
