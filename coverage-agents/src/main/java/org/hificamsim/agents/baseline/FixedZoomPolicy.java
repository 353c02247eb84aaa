package org.hificamsim.agents.baseline;

import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.agents.choice.PanAngles;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;

/**
 * Levels given by the user and never changed: {@code fixed:2} for all cameras, or {@code
 * fixed:0,1,2} with one level for each camera in the scenario's order, those that are added later
 * included. Cameras that turn look ahead, or where {@code fixed:0,1,2,pans=3,0,4} says.
 */
public final class FixedZoomPolicy implements ZoomPolicy {
  private static final int MAX_NUMBER = 1_000_000;

  private final List<Integer> levels;
  private final List<Integer> pans;
  private int[] fixed = {};

  /** Reads the option {@code levels}, which needs no key, and {@code pans}. */
  public FixedZoomPolicy(Options options) {
    levels =
        options.integers(
            "levels",
            List.of(0),
            0,
            MAX_NUMBER,
            "level of all cameras, or of each as in 0,2,1; 0 the narrowest");
    pans =
        options.integers(
            "pans",
            List.of(),
            0,
            MAX_NUMBER,
            "pan angle of all cameras, or of each as in 0,2,1; 0 the first; not given: ahead");
  }

  @Override
  public String name() {
    return "fixed";
  }

  /**
   * @throws InputException when a camera lacks the level or pan angle given for it, or their number
   *     is neither 1 nor that of the cameras
   */
  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    checkCount("levels", levels, network);
    if (!pans.isEmpty()) {
      checkCount("pans", pans, network);
    }
    fixed = new int[network.cameras()];
    for (int camera = 0; camera < fixed.length; camera++) {
      fixed[camera] = network.viewAt(camera, pan(network, camera), level(network, camera));
    }
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    System.arraycopy(fixed, 0, views, 0, fixed.length);
  }

  private int level(NetworkView network, int camera) {
    int level = given(levels, camera);
    int widest = network.zooms(camera) - 1;
    if (level < 0 || level > widest) {
      throw invalid("level", network, camera, level, "0 (narrowest) to " + widest + " (widest)");
    }
    return level;
  }

  private int pan(NetworkView network, int camera) {
    if (pans.isEmpty()) {
      return PanAngles.home(network, camera);
    }
    int pan = given(pans, camera);
    int last = network.pans(camera) - 1;
    if (pan < 0 || pan > last) {
      throw invalid("pan", network, camera, pan, "0 (first pan angle) to " + last + " (last)");
    }
    return pan;
  }

  private static int given(List<Integer> numbers, int camera) {
    return numbers.get(numbers.size() == 1 ? 0 : camera);
  }

  private static void checkCount(String option, List<Integer> given, NetworkView network) {
    if (given.size() != 1 && given.size() != network.cameras()) {
      throw InputException.of(
          "policy fixed: %s has %s values, expected 1 for all cameras or %s, one for each",
          option, given.size(), network.cameras());
    }
  }

  private static InputException invalid(
      String what, NetworkView network, int camera, int number, String expected) {
    return InputException.of(
        "policy fixed: %s of camera '%s' is %s, expected %s",
        what, network.cameraName(camera), number, expected);
  }
}
