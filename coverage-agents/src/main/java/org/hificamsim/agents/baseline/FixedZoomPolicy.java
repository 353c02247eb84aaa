package org.hificamsim.agents.baseline;

import java.util.List;
import java.util.SplittableRandom;
import org.hificamsim.agents.choice.PanAngles;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.NetworkView;
import org.hificamsim.core.policy.ZoomPolicy;
import org.hificamsim.core.registry.Options;

/**
 * Zoom levels that the user gives, and that never change: {@code fixed:2} for all cameras, or
 * {@code fixed:0,1,2} with one level for each camera in the scenario's order, including those that
 * are added later. Cameras that can turn look ahead, or at the pan angles of {@code
 * fixed:0,1,2,pans=3,0,4}.
 */
public final class FixedZoomPolicy implements ZoomPolicy {
  private static final int MAX_NUMBER = 1_000_000;

  private final List<Integer> levels;
  private final List<Integer> pans;
  private int[] fixedViews = {};

  /** Reads the options {@code levels}, which needs no key, and {@code pans}. */
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
   * @throws InputException if a camera does not have the level or pan angle given for it, or if
   *     their number is neither 1 nor the number of cameras
   */
  @Override
  public void begin(NetworkView network, SplittableRandom random) {
    checkCount("levels", levels, network);
    if (!pans.isEmpty()) {
      checkCount("pans", pans, network);
    }
    fixedViews = new int[network.cameras()];
    for (int camera = 0; camera < fixedViews.length; camera++) {
      fixedViews[camera] = network.viewAt(camera, pan(network, camera), level(network, camera));
    }
  }

  @Override
  public void decide(NetworkView network, int[] views) {
    System.arraycopy(fixedViews, 0, views, 0, fixedViews.length);
  }

  private int level(NetworkView network, int camera) {
    int level = ofCamera(levels, camera);
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
    int pan = ofCamera(pans, camera);
    int last = network.pans(camera) - 1;
    if (pan < 0 || pan > last) {
      throw invalid("pan", network, camera, pan, "0 (first pan angle) to " + last + " (last)");
    }
    return pan;
  }

  private static int ofCamera(List<Integer> numbers, int camera) {
    return numbers.get(numbers.size() == 1 ? 0 : camera);
  }

  private static void checkCount(String option, List<Integer> numbers, NetworkView network) {
    if (numbers.size() != 1 && numbers.size() != network.cameras()) {
      throw InputException.of(
          "policy fixed: %s has %s values, expected 1 for all cameras or %s, one for each",
          option, numbers.size(), network.cameras());
    }
  }

  private static InputException invalid(
      String name, NetworkView network, int camera, int number, String expected) {
    return InputException.of(
        "policy fixed: %s of camera '%s' is %s, expected %s",
        name, network.cameraName(camera), number, expected);
  }
}
