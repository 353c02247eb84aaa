package org.hificamsim.agents.baseline;

import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;

/**
 * Levels given by the user and never changed: {@code fixed:2} for all cameras, or {@code
 * fixed:0,1,2} with one level for each camera in the scenario's order, those that are added later
 * included.
 */
public final class FixedZoomPolicy implements ZoomPolicy {
  public static final String NAME = "fixed";

  private static final int MAX_LEVEL = 1_000_000;

  private final List<Integer> given;
  private int[] fixed = {};

  /**
   * @param levels one level for all cameras, or one for each
   */
  public FixedZoomPolicy(List<Integer> levels) {
    given = List.copyOf(levels);
  }

  /** The policy with the option {@code levels}, default 0, which may be given without its key. */
  public static FixedZoomPolicy from(Options options) {
    return new FixedZoomPolicy(
        options.integers(
            "levels",
            List.of(0),
            0,
            MAX_LEVEL,
            "level of all cameras, or of each as in 0,2,1; 0 the narrowest"));
  }

  @Override
  public String name() {
    return NAME;
  }

  /**
   * @throws InputException when a camera lacks the level given for it, or the number of levels is
   *     neither 1 nor that of the cameras
   */
  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    int cameras = network.cameras();
    if (given.size() != 1 && given.size() != cameras) {
      throw new InputException(
          "policy fixed: levels has "
              + given.size()
              + " values, expected 1 for all cameras or "
              + cameras
              + ", one for each");
    }
    fixed = new int[cameras];
    for (int camera = 0; camera < cameras; camera++) {
      fixed[camera] = checked(network, camera, given.get(given.size() == 1 ? 0 : camera));
    }
  }

  @Override
  public void decide(NetworkView network, int[] levels) {
    System.arraycopy(fixed, 0, levels, 0, fixed.length);
  }

  private static int checked(NetworkView network, int camera, int level) {
    int widest = network.views(camera) - 1;
    if (level < 0 || level > widest) {
      throw new InputException(
          "policy fixed: level of camera '"
              + network.cameraName(camera)
              + "' is "
              + level
              + ", expected 0 (narrowest) to "
              + widest
              + " (widest)");
    }
    return level;
  }
}
