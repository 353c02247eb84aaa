package org.hificamsim.agents.observation;

import java.util.ArrayList;
import java.util.List;
import java.util.stream.IntStream;
import org.hificamsim.core.InputException;
import org.hificamsim.core.policy.NetworkView;

/**
 * The numbers of an observation in their order: those of the camera itself, of its nearest
 * neighbours, of the nearest targets that it sees, and, if asked for, of what its views promise by
 * the belief that the cameras share. The numbers of neighbours, targets and views that do not exist
 * are 0, and so are all numbers of a camera that is off.
 *
 * @param targets number of targets in the observation, 0 or more
 * @param neighbours number of neighbours in the observation, 0 or more
 * @param heights whether the heights and tilts of cameras are in the observation
 * @param views number of views of which the observation says what they promise, the most that a
 *     camera of the network has; 0 for an observation without belief
 */
public record ObservationLayout(int targets, int neighbours, boolean heights, int views) {
  /** The default layout: 4 targets and 2 neighbours, without heights. */
  public static final ObservationLayout DEFAULT = new ObservationLayout(4, 2, false);

  private static final int MAX_OBSERVED = 1_000;

  static final List<Feature> OWN =
      List.of(
          Feature.share("online", "1, or 0 for a camera that is off: then all else is 0 too"),
          Feature.signed("x", "place among the cameras of the start: -1 and 1 are the outermost"),
          Feature.signed("y", "the same to +y, on the same scale as x"),
          Feature.signed("mounted_x", "x of the unit vector along the mounted heading"),
          Feature.signed("mounted_y", "y of it"),
          Feature.signed("goal_pan", "pan angle of the view chosen last, over pi, to the right"),
          Feature.share("goal_zoom", "zoom level of that view: 0 narrowest, 1 widest"),
          Feature.signed("pan", "pan angle of the view that it sees through; 0 when blind"),
          Feature.share("zoom", "zoom level of the view that it sees through; 0 when blind"),
          Feature.share("angle", "opening angle of that view, over 2 pi; 0 when blind"),
          Feature.share("blind", "1 while it sees nothing, on its way"),
          Feature.share("moving", "1 while it is on its way"),
          Feature.share("way", "n / (n + 1) after n decisions on its way"),
          Feature.share("detected", "share of all targets that it detected in the last step"));

  private static final List<Feature> OWN_HEIGHTS =
      List.of(
          Feature.share("height", "height of the lens above the ground, over 10 m"),
          Feature.signed("goal_tilt", "tilt of the view chosen last, over pi / 2, downwards"),
          Feature.signed("tilt", "tilt of the view that it sees through; 0 when blind"));

  static final List<Feature> NEIGHBOUR =
      List.of(
          Feature.signed("dx", "how far the neighbour is in x, half the scale of x and y"),
          Feature.signed("dy", "the same in y"),
          Feature.share("detected", "share of all targets that it detected in the last step"));

  static final List<Feature> TARGET =
      List.of(
          Feature.share("seen", "1; 0 where no further target is seen"),
          Feature.signed("ahead", "how far along the view's axis, over its reach"),
          Feature.signed("right", "how far to the right of the axis, over the reach"),
          Feature.share("size", "share of the opening angle that it takes, about: size / distance"),
          Feature.share("confidence", "the detection model's"),
          Feature.share("coverage", "share of the cameras that detected it in the last step"));

  /** Checks that the numbers of targets and neighbours are in their range. */
  public ObservationLayout {
    check("targets", targets);
    check("neighbours", neighbours);
  }

  /** Creates a layout without belief. */
  public ObservationLayout(int targets, int neighbours, boolean heights) {
    this(targets, neighbours, heights, 0);
  }

  /** Returns the layout that also says what the views of a network's cameras promise. */
  public ObservationLayout withBelief(NetworkView network) {
    return withViews(IntStream.range(0, network.cameras()).map(network::views).max().orElse(0));
  }

  /** Returns the layout that also says what this number of views promises. */
  public ObservationLayout withViews(int newViews) {
    return new ObservationLayout(targets, neighbours, heights, newViews);
  }

  private static void check(String name, int number) {
    if (number < 0 || number > MAX_OBSERVED) {
      throw InputException.of("observed %s is %s, expected 0 to %s", name, number, MAX_OBSERVED);
    }
  }

  /** Returns the index of one of the numbers that describe the camera itself. */
  static int at(String name) {
    return IntStream.range(0, OWN.size())
        .filter(i -> OWN.get(i).name().equals(name))
        .findFirst()
        .orElseThrow();
  }

  /** The length of an observation. */
  public int size() {
    return firstView() + views * viewSize();
  }

  /** Returns the number of numbers that describe the camera itself; they come first. */
  public int ownSize() {
    return OWN.size() + (heights ? OWN_HEIGHTS.size() : 0);
  }

  /** The index of the first number of the first target. */
  int firstTarget() {
    return ownSize() + neighbours * NEIGHBOUR.size();
  }

  /** The index of the first number of the first view. */
  public int firstView() {
    return firstTarget() + targets * TARGET.size();
  }

  /** Returns the number of numbers that describe a view. */
  public static int viewSize() {
    return BeliefFeatures.VIEW.size();
  }

  /** The numbers of an observation, in order. */
  public List<Feature> features() {
    List<Feature> features = new ArrayList<>(OWN);
    if (heights) {
      features.addAll(OWN_HEIGHTS);
    }
    addNumbered(features, "neighbour", neighbours, NEIGHBOUR);
    addNumbered(features, "target", targets, TARGET);
    addNumbered(features, "view", views, BeliefFeatures.VIEW);
    return features;
  }

  private static void addNumbered(
      List<Feature> features, String owner, int owners, List<Feature> numbers) {
    for (int owned = 0; owned < owners; owned++) {
      int number = owned;
      numbers.forEach(feature -> features.add(feature.numbered(owner, number)));
    }
  }
}
